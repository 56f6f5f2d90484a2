#ifndef springfit_fit_cell_frobenius_h
#define springfit_fit_cell_frobenius_h

#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

namespace springfit
{
  // The functions below take B and a symmetric matrix R of as many rows, on
  // all coordinates of a cell or projected on its deformations alike: the
  // gradients lie in that subspace.

  /**
   * The Gram matrix of the tangents b_s b_s^T,
   * G_st = <b_s b_s^T, b_t b_t^T> = (b_s . b_t)^2. It is positive definite
   * for springs between distinct pairs of nodes: each tangent alone has
   * entries in its off-diagonal block.
   */
  Eigen::MatrixXd
  tangent_gram(const Eigen::MatrixXd &B);

  /** The products b_s^T R b_s, one per spring. */
  Eigen::VectorXd
  tangent_products(const Eigen::MatrixXd &B, const Eigen::MatrixXd &R);

  /**
   * The minimiser of ||R - B diag(k) B^T||_F, from its normal equations
   * sum_t (b_s . b_t)^2 k_t = b_s^T R b_s ("F-norm" of Natsupakpong and
   * Cavusoglu 2010).
   *
   * @param n_nonnegative how many of the k, from the first on, must not be
   * negative
   * @return one k per column of B, in the units of R
   */
  Eigen::VectorXd
  fit_frobenius(const Eigen::MatrixXd &B,
                const Eigen::MatrixXd &R,
                Eigen::Index n_nonnegative);

  /**
   * Of a cell, see approximation.h; with states as several_states.h says.
   */
  FittedCell
  fit_frobenius(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
