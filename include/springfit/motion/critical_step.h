#ifndef springfit_motion_critical_step_h
#define springfit_motion_critical_step_h

#include <springfit/motion/moving_body.h>

#include <Eigen/Core>

namespace springfit
{
  /** How large a step symplectic Euler's method bears. */
  struct CriticalStep
  {
    double step; // s; infinite where nothing moves or nothing resists

    /** The motion that sets it, of norm 1, dim x n_nodes. */
    Eigen::MatrixXd shape;
  };

  /**
   * That of a body with its lumped masses at a displacement (m), by
   * largest_mode() to 0.001 %: the tangent with the stress stiffness,
   * Rayleigh's damping, loads as if their largest stiffness were that of every
   * node, and dampers as if all of them damped the fastest motion, which is
   * never too large a step.
   */
  CriticalStep
  critical_step(const MovingBody &body, const Eigen::MatrixXd &displacement);
} // namespace springfit

#endif
