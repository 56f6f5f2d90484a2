#ifndef springfit_motion_step_system_h
#define springfit_motion_step_system_h

#include <springfit/motion/moving_body.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * What an implicit step asks for: products with the tangent stiffness K at a
   * state, and solutions with sums of the masses M and K.
   */
  class StepSystem
  {
  public:
    virtual ~StepSystem() = default;

    /** K is that at @p displacement from now on. */
    virtual void
    linearise(const Eigen::MatrixXd &displacement) = 0;

    /** K u, N */
    virtual Eigen::MatrixXd
    stiffness_product(const Eigen::MatrixXd &u) const = 0;

    /**
     * y of (mass_factor M + stiffness_factor K) y = @p forces, 0 where held.
     *
     * @throws RunError when the matrix is singular.
     */
    virtual Eigen::MatrixXd
    solve(double mass_factor,
          double stiffness_factor,
          const Eigen::MatrixXd &forces) = 0;
  };
} // namespace springfit

#endif
