#ifndef springfit_fit_block_h
#define springfit_fit_block_h

#include <springfit/fit/problem.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * Each spring from its own off-diagonal block of R: the minimiser of
   * ||R_ij + k n n^T||_F is k = -n^T R_ij n, with n the spring's direction
   * (Natsupakpong and Cavusoglu 2010, equations (27) and (29)).
   *
   * @return one k per spring, N/m
   */
  Eigen::VectorXd
  fit_block(const FitProblem &problem);

  /**
   * The same with k >= 0. The problem is one quadratic per spring, so its
   * minimiser is the free one with negative values replaced by zero.
   */
  Eigen::VectorXd
  fit_block_nonnegative(const FitProblem &problem);
} // namespace springfit

#endif
