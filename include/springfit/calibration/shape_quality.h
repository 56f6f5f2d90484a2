#ifndef springfit_calibration_shape_quality_h
#define springfit_calibration_shape_quality_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * The scaled Jacobian of a cell (Knupp 2000): the smallest over its corners
   * of the determinant of the edges there divided by the product of their
   * lengths, and by that of the regular cell. 1 is the regular triangle and
   * tetrahedron, and a rectangular box; 0 is degenerate.
   *
   * @p points dim x n_vertices in deal.II's numbering, m.
   */
  double
  shape_quality(const Eigen::MatrixXd &points, CellKind kind);
} // namespace springfit

#endif
