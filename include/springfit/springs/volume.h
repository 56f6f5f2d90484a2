#ifndef springfit_springs_volume_h
#define springfit_springs_volume_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

namespace springfit
{
  // The coordinate of a volume spring: the volume of a cell (m^3), in 2-d its
  // area (m^2), of the P1 or Q1 mapping of its vertices in deal.II's
  // numbering. It is a polynomial in the coordinates, integrated exactly.
  // A cell turned inside out has a negative one.
  //
  // @p points dim x n_vertices, m. Gradients have dim * n_vertices entries,
  // row dim * v + d for component d of vertex v.

  double
  volume(const Eigen::MatrixXd &points, CellKind kind);

  Eigen::VectorXd
  volume_gradient(const Eigen::MatrixXd &points, CellKind kind);

  Eigen::MatrixXd
  volume_hessian(const Eigen::MatrixXd &points, CellKind kind);

  /**
   * The kind of the cell that has @p n_vertices in @p dim dimensions.
   *
   * @throws std::logic_error when there is none.
   */
  CellKind
  cell_kind(int dim, std::size_t n_vertices);
} // namespace springfit

#endif
