#ifndef springfit_motion_step_matrix_h
#define springfit_motion_step_matrix_h

#include <springfit/motion/moving_body.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace springfit
{
  // The matrix mass_factor M + stiffness_factor K of an implicit step with the
  // tangent stiffness K at a displacement (dim x n_nodes, m); both factors > 0.

  /** A matrix of its sparsity, zero. */
  TangentMatrix
  empty_step_matrix(int dim, const MovingBody &body);

  /** Make rows and columns of held unknowns those of the unit matrix. */
  void
  put_ones_where_held(const MovingBody &body,
                      Eigen::SparseMatrix<double> &matrix);

  /**
   * All of it, (dim * n_nodes)^2, of a tangent stiffness K; see
   * put_ones_where_held().
   */
  Eigen::SparseMatrix<double>
  step_matrix(const MovingBody &body,
              const TangentMatrix &tangent,
              double mass_factor,
              double stiffness_factor);

  /** The same with the tangent at a displacement. */
  Eigen::SparseMatrix<double>
  step_matrix(int dim,
              const MovingBody &body,
              const Eigen::MatrixXd &displacement,
              double mass_factor,
              double stiffness_factor);

  /**
   * An n_nodes x n_nodes matrix that resembles it on each component of a
   * motion: K's blocks of two nodes are replaced by their mean diagonal entry,
   * 0 where that is positive, and K's diagonal keeps the sums of rows 0, so
   * that it is a Laplacian on the graph of the nodes and the whole positive
   * definite. Nodes that are held in all components have rows and columns of
   * the unit matrix. For isotropic elasticity at rest it is, up to a factor,
   * spectrally equivalent by Korn's inequality (Axelsson 1998, On iterative
   * solvers in structural mechanics: separate displacement orderings).
   */
  Eigen::SparseMatrix<double>
  scalar_step_matrix(int dim,
                     const MovingBody &body,
                     const Eigen::MatrixXd &displacement,
                     double mass_factor,
                     double stiffness_factor);
} // namespace springfit

#endif
