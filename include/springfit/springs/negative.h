#ifndef springfit_springs_negative_h
#define springfit_springs_negative_h

#include <Eigen/Core>

namespace springfit
{
  /**
   * The number of negative stiffness constants: those below -1e-12 times the
   * largest magnitude, so that a zero with a rounding error is none.
   */
  unsigned int
  n_negative(const Eigen::Ref<const Eigen::VectorXd> &k);
} // namespace springfit

#endif
