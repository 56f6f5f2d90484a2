#ifndef springfit_fit_programs_nonnegative_least_squares_h
#define springfit_fit_programs_nonnegative_least_squares_h

#include <Eigen/Core>

namespace springfit
{
  /**
   * The minimiser of x^T G x / 2 - g^T x over x whose first @p n_nonnegative
   * entries are >= 0, by the active set method of Lawson and Hanson 1974,
   * chapter 23, on the normal equations.
   *
   * @param G symmetric positive definite, n x n
   * @return x with w = g - G x zero in the free entries, and in the others
   * x_s >= 0, w_s <= 0, x_s w_s = 0 up to rounding
   *
   * @throws RunError when G is singular up to rounding, or the active sets do
   * not settle.
   */
  Eigen::VectorXd
  nonnegative_least_squares(const Eigen::MatrixXd &G,
                            const Eigen::VectorXd &g,
                            Eigen::Index n_nonnegative);
} // namespace springfit

#endif
