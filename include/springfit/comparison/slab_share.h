#ifndef springfit_comparison_slab_share_h
#define springfit_comparison_slab_share_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * The part of a simplex's volume that lies below a height, given the heights
   * of its vertices: the integral of the B-spline with these knots (Curry and
   * Schoenberg 1966), by the recursion of Cox and de Boor. Equal heights do no
   * harm.
   */
  double
  simplex_share_below(std::vector<double> heights, double level);

  /**
   * The part of a cell's volume with lowest <= axis . x <= highest, between 0
   * and 1. Quadrilaterals and hexahedra are cut into simplices along their
   * main diagonal, which is exact for plane faces.
   *
   * @p points spacedim x n_vertices in deal.II's numbering and @p axis in the
   * same unit as the bounds.
   */
  double
  slab_share(const Eigen::MatrixXd &points,
             CellKind kind,
             const Eigen::VectorXd &axis,
             double lowest,
             double highest);
} // namespace springfit

#endif
