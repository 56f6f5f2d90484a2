#ifndef springfit_fit_cell_regularity_h
#define springfit_fit_cell_regularity_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

namespace springfit
{
  // Whether a cell is of the shape that a published formula is derived for,
  // to 1 % of its lengths. @p points dim x n_vertices.

  /** An equilateral triangle, square, regular tetrahedron or cube. */
  bool
  is_regular(const Eigen::MatrixXd &points, CellKind kind);

  /** A quadrilateral with equal diagonals and equal opposite edges. */
  bool
  is_rectangle(const Eigen::MatrixXd &points);

  /** What is_regular() asks of cells: "squares" and so on. */
  const char *
  regular_cells(CellKind kind);
} // namespace springfit

#endif
