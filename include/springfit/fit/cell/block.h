#ifndef springfit_fit_cell_block_h
#define springfit_fit_cell_block_h

#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * The minimiser of the Frobenius norm of the blocks R_ij - K_ij, i != j,
   * between two nodes, K = B diag(k) B^T: what a node does to itself is left
   * out. Springs alone have one block each, and then it is
   * k = -n^T R_ij n with n the spring's direction (Natsupakpong and Cavusoglu
   * 2010, equations (27) and (29)).
   *
   * @param B (dim * n_nodes) x n_terms, the gradients of springs and others
   * @param R (dim * n_nodes) x (dim * n_nodes)
   * @param n_nonnegative how many of the k, from the first on, must not be
   * negative
   * @return one k per column of B, in the units of R
   */
  Eigen::VectorXd
  fit_block(const Eigen::MatrixXd &B,
            const Eigen::MatrixXd &R,
            Eigen::Index dim,
            Eigen::Index n_nonnegative);

  /** Of a cell, see approximation.h. */
  FittedCell
  fit_block(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
