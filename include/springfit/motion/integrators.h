#ifndef springfit_motion_integrators_h
#define springfit_motion_integrators_h

#include <springfit/motion/moving_body.h>
#include <springfit/motion/step_system.h>

namespace springfit
{
  /** How an implicit step is to be solved. */
  struct NewtonLimits
  {
    /** The forces left over, relative to those at the beginning. */
    double tolerance = 1e-8;

    /** 1: one linearisation, whatever is left over. */
    unsigned int n_iterations = 20;
  };

  // Each goes on from the state by one step of @p step seconds. Held unknowns
  // follow their support; their velocity is its difference quotient, of the
  // step in the methods of first order.

  /**
   * v += h a(x, v), x += h v: explicit, of first order, symplectic without
   * damping, so that its energy oscillates but does not drift. Stable for steps
   * below stable_step().
   *
   * @param tangent K at the state, asked for with stiffness damping only
   */
  void
  symplectic_euler_step(const MovingBody &body,
                        StepSystem &system,
                        double step,
                        MotionState &state);

  /**
   * v_1 = v_0 + h a(x_1, v_1), x_1 = x_0 + h v_1: of first order, stable for
   * every step, damps high frequencies (Baraff and Witkin 1998 with one
   * linearisation).
   *
   * @throws RunError when Newton's method does not converge in more than one
   * iteration, or the matrix is singular; the state is that before the step.
   */
  void
  implicit_euler_step(const MovingBody &body,
                      StepSystem &system,
                      const NewtonLimits &limits,
                      double step,
                      MotionState &state);

  /** The numbers of the generalised alpha method. */
  struct GeneralisedAlpha
  {
    double alpha_m, alpha_f, beta, gamma;
  };

  /**
   * Of second order with the spectral radius @p rho of infinite frequencies, 1:
   * no damping, 0: they vanish in a step (Chung and Hulbert 1993, equations 17,
   * 20 and 25).
   */
  GeneralisedAlpha
  generalised_alpha(double rho);

  /** Newmark's method; beta = 1/4, gamma = 1/2 is the trapezoidal rule. */
  GeneralisedAlpha
  newmark(double beta, double gamma);

  /**
   * The acceleration in which a motion begins: that of the forces there; what
   * is held keeps its own.
   */
  void
  set_acceleration(const MovingBody &body,
                   StepSystem &system,
                   MotionState &state);

  /**
   * A step of the generalised alpha method. The state's acceleration must be
   * that of set_acceleration() or of the step before.
   *
   * @throws RunError as implicit_euler_step() does.
   */
  void
  generalised_alpha_step(const MovingBody &body,
                         StepSystem &system,
                         const GeneralisedAlpha &method,
                         const NewtonLimits &limits,
                         double step,
                         MotionState &state);
} // namespace springfit

#endif
