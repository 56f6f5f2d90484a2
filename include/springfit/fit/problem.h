#ifndef springfit_fit_problem_h
#define springfit_fit_problem_h

#include <springfit/springs/cell_topology.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * What a fit is given: find k such that B diag(k) B^T resembles R.
   */
  struct FitProblem
  {
    /** The cell's vertices, dim x n_nodes, m */
    Eigen::MatrixXd points;

    std::vector<NodePair> springs;

    /** B, (dim * n_nodes) x n_springs: the gradients b_s, see gradients.h */
    Eigen::MatrixXd gradients;

    /** R, (dim * n_nodes) x (dim * n_nodes), N/m: the cell's stiffness */
    Eigen::MatrixXd stiffness;
  };

  /** The problem of a cell whose vertices are fully connected. */
  FitProblem
  make_fit_problem(const Eigen::MatrixXd &points,
                   CellKind kind,
                   const Eigen::MatrixXd &stiffness);

  /** E(k) = R - B diag(k) B^T, what the springs miss. */
  Eigen::MatrixXd
  residual(const FitProblem &problem, const Eigen::VectorXd &k);
} // namespace springfit

#endif
