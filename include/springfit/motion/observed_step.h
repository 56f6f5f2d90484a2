#ifndef springfit_motion_observed_step_h
#define springfit_motion_observed_step_h

#include <springfit/motion/moving_body.h>
#include <springfit/motion/step_system.h>

#include <Eigen/Core>

#include <cstdint>

namespace springfit
{
  /** What steps of symplectic Euler's method make of a disturbed body. */
  struct ObservedMotion
  {
    bool grows; // beyond all bounds

    /**
     * The change of the energy from the first to the last tenth of the steps,
     * each its mean, relative to the first; of bodies without damping and loads
     * nothing but an error.
     */
    double energy_drift;
  };

  /**
   * Let a body at rest (of the displacement 0) go from small random
   * displacements, the same in every run, for so many steps of @p step, s. It
   * grows when its velocity does a thousandfold from the first steps to later
   * ones, or where it has no energy.
   *
   * @param size of its smallest springs or cells, m: the disturbance is up to
   * 1e-6 of that
   */
  ObservedMotion
  observe(const MovingBody &body,
          StepSystem &system,
          int dim,
          double step,
          std::uint64_t n_steps,
          double size);

  /**
   * The largest step, in s, with which it does not grow, by bisection from 0.5
   * to 2 times @p guess until the interval is @p width of it. The lower end,
   * or 0 where it grows already there; 2 guess where it never does.
   */
  double
  observed_step(const MovingBody &body,
                StepSystem &system,
                int dim,
                double guess,
                std::uint64_t n_steps,
                double width,
                double size);
} // namespace springfit

#endif
