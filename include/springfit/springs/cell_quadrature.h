#ifndef springfit_springs_cell_quadrature_h
#define springfit_springs_cell_quadrature_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * A point of the reference cell: the gradients of the P1 or Q1 shape
   * functions there, dim x n_vertices in deal.II's numbering, and its weight.
   */
  struct QuadraturePoint
  {
    Eigen::MatrixXd gradients;
    double weight;
  };

  /**
   * Gauss' quadrature on the reference cell: one point in simplices, two per
   * direction in the others. The weights sum to the reference cell's volume.
   */
  const std::vector<QuadraturePoint> &
  cell_quadrature(CellKind kind);
} // namespace springfit

#endif
