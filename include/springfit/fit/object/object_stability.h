#ifndef springfit_fit_object_object_stability_h
#define springfit_fit_object_object_stability_h

#include <springfit/fit/object/object_problem.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * How far the constants can go from @p stable towards @p unstable until the
   * object releases energy in a deformation, to 1e-3 of the way: the largest t
   * for which K((1 - t) stable + t unstable) is positive semidefinite. As such
   * matrices are a convex set, so it is for all smaller t.
   *
   * A sparse factorisation for each of ten bisections.
   */
  double
  share_to_instability(const ObjectProblem &problem,
                       const Eigen::VectorXd &stable,
                       const Eigen::VectorXd &unstable);
} // namespace springfit

#endif
