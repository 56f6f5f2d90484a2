#ifndef springfit_fit_programs_bounded_least_squares_h
#define springfit_fit_programs_bounded_least_squares_h

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace springfit
{
  /** A matrix (m x n) that is known by its products only. */
  struct LinearMap
  {
    std::function<Eigen::VectorXd(const Eigen::VectorXd &)> apply;
    std::function<Eigen::VectorXd(const Eigen::VectorXd &)> apply_transposed;
  };

  /**
   * The x that minimises |b - B x|^2 + sum_s ((x_s - prior_s) / scale_s)^2 with
   * x_s >= 0 where nonnegative[s]. There is exactly one.
   *
   * Given the residual y = b - B x the minimiser is
   * x(y) = prior + scale^2 B^T y, raised to its bounds, so that y + B x(y) = b
   * is left to be solved: the gradient of a strictly convex function, linear in
   * pieces. Newton's method (Qi and Sun 1993; Li and Swetits 1997) with a line
   * search finds its zero, conjugate gradients each step. These are few where
   * few singular values of B diag(scale) are large.
   *
   * @param B m x n
   * @param b m
   * @param prior, scale n, in the units of x; scale is positive
   *
   * @throws RunError when y misses its equation by more than 1e-8 |b|
   */
  Eigen::VectorXd
  bounded_least_squares(const LinearMap &B,
                        const Eigen::VectorXd &b,
                        const Eigen::VectorXd &prior,
                        const Eigen::VectorXd &scale,
                        const std::vector<bool> &nonnegative);
} // namespace springfit

#endif
