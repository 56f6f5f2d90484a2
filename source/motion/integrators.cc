#include <springfit/core/error.h>
#include <springfit/motion/integrators.h>
#include <springfit/motion/meet_obstacles.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace springfit
{
  namespace
  {
    /** C v at a state's displacement, with K as the system has it. */
    Eigen::MatrixXd
    damping_of_step(const MovingBody &body,
                    const StepSystem &system,
                    const MotionState &state)
    {
      Eigen::MatrixXd forces =
        body.damping.mass_factor * mass_product(body, state.velocity);
      if (body.damping.stiffness_factor != 0.)
        forces += body.damping.stiffness_factor *
                  system.stiffness_product(state.velocity);
      if (are_there(body.dampers))
        forces +=
          damper_product(body.dampers, state.displacement, state.velocity);
      return forces;
    }

    /** Where forces are not finite, or else largest, and not held. */
    Eigen::Index
    node_of_largest(const MovingBody &body, const Eigen::MatrixXd &forces)
    {
      const Eigen::Index dim = forces.rows();
      Eigen::Index largest   = 0;
      double size            = -1.;
      for (Eigen::Index i = 0; i < forces.size(); ++i)
        if (!body.held[i])
          {
            const double here = std::abs(forces.reshaped()[i]);
            if (!std::isfinite(here))
              return i / dim;
            if (here > size)
              {
                size    = here;
                largest = i / dim;
              }
          }
      return largest;
    }

    bool
    is_damped(const MovingBody &body)
    {
      return body.damping.mass_factor != 0. ||
             body.damping.stiffness_factor != 0. || are_there(body.dampers);
    }

    /**
     * Gives held unknowns the velocity that leads them from the state before a
     * step to where the support is at its end, state.time, and no forces.
     */
    void
    move_held(const MovingBody &body,
              const double step,
              MotionState &state,
              Eigen::MatrixXd &forces)
    {
      const bool moves = static_cast<bool>(body.support);
      Eigen::MatrixXd there;
      if (moves)
        {
          there = state.displacement;
          body.support(state.time, there);
        }
      const double *x = state.displacement.data();
      for (std::size_t i = 0; i < body.held.size(); ++i)
        if (body.held[i])
          {
            forces.data()[i] = 0.;
            state.velocity.data()[i] =
              moves ? (there.data()[i] - x[i]) / step : 0.;
          }
    }

    [[noreturn]] void
    refuse_step(const double time, const std::string &what)
    {
      throw RunError("The step to t = " + std::to_string(time) + " s " + what +
                       '.',
                     "Choose a smaller step.");
    }

    /** The equations of a step for an unknown motion y. */
    struct StepEquations
    {
      /** The state that y stands for, at which forces and K are taken. */
      std::function<MotionState(const Eigen::MatrixXd &y)> state;

      /** What of the forces there y leaves over, with K of the system. */
      std::function<Eigen::MatrixXd(const Eigen::MatrixXd &y,
                                    const MotionState &state,
                                    const Eigen::MatrixXd &driving)>
        left_over;

      /** Of the derivative of what is left over by y. */
      StepFactors factors;
    };

    // The derivative of K in the damping is left out of Newton's matrix: the
    // forces left over are exact.
    void
    solve_by_newton(const MovingBody &body,
                    StepSystem &system,
                    const StepEquations &equations,
                    const NewtonLimits &limits,
                    const double end_time,
                    Eigen::MatrixXd &y)
    {
      double reference = 0.;
      for (unsigned int i = 0;; ++i)
        {
          const MotionState state = equations.state(y);
          system.linearise(state);
          const Eigen::MatrixXd driving = driving_forces(body, state);
          const Eigen::MatrixXd rest = equations.left_over(y, state, driving);
          const double size          = norm_of_free(body, rest);
          if (!std::isfinite(size))
            refuse_step(end_time,
                        "leads to forces that are not finite, at node " +
                          std::to_string(node_of_largest(body, rest)));
          reference = std::max({reference, norm_of_free(body, driving), size});
          if (size <= limits.tolerance * reference || size <= body.rounding)
            return;
          if (i == limits.n_iterations)
            refuse_step(end_time,
                        "did not converge in " + std::to_string(i) +
                          " iterations of Newton's method: the forces left "
                          "over are largest at node " +
                          std::to_string(node_of_largest(body, rest)));
          y += system.solve(equations.factors, rest);
        }
    }
  } // namespace


  void
  symplectic_euler_step(const MovingBody &body,
                        StepSystem &system,
                        const double step,
                        MotionState &state)
  {
    Eigen::MatrixXd forces = driving_forces(body, state);
    if (body.damping.stiffness_factor != 0.)
      system.linearise(state);
    if (is_damped(body))
      forces -= damping_of_step(body, system, state);
    state.time += step;
    if (!body.held.empty())
      move_held(body, step, state, forces);
    // In one loop over the nodes: the memory is what a step waits for.
    for (Eigen::Index v = 0; v < body.mass.size(); ++v)
      {
        state.velocity.col(v) += step / body.mass[v] * forces.col(v);
        state.displacement.col(v) += step * state.velocity.col(v);
      }
  }


  void
  implicit_euler_step(const MovingBody &body,
                      StepSystem &system,
                      const NewtonLimits &limits,
                      const double step,
                      MotionState &state)
  {
    const double end               = state.time + step;
    const RayleighDamping &damping = body.damping;
    const StepFactors factors      = {1. + step * damping.mass_factor,
                                      step * (step + damping.stiffness_factor),
                                      step * step,
                                      step};
    const Eigen::MatrixXd there = with_supports(body, end, state.displacement);
    const Eigen::MatrixXd impulse = mass_product(body, state.velocity);

    // From x_0 on, so that one linearisation does not see the supports jump.
    MotionState begin = state;
    begin.time        = end;
    system.linearise(begin);
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(there.rows(), there.cols());
    copy_held(body, (there - state.displacement) / step, y);
    Eigen::MatrixXd forces = step * driving_forces(body, begin) + impulse;
    if (!y.isZero(0.)) // the supports move
      {
        forces -= factors.stiffness * system.stiffness_product(y) +
                  factors.mass * mass_product(body, y);
        if (are_there(body.dampers))
          forces -= factors.dampers *
                    damper_product(body.dampers, state.displacement, y);
      }
    y += system.solve(factors, forces);
    if (limits.n_iterations == 1 && body.load_stiffness)
      meet_obstacles(body,
                     system,
                     factors,
                     norm_of_free(body, forces),
                     limits.tolerance,
                     step,
                     begin,
                     y);

    if (limits.n_iterations > 1)
      {
        StepEquations equations;
        equations.factors = factors;
        equations.state   = [&](const Eigen::MatrixXd &velocity) {
          MotionState next  = begin;
          next.velocity     = velocity;
          next.displacement = state.displacement + step * velocity;
          return next;
        };
        equations.left_over = [&](const Eigen::MatrixXd &velocity,
                                  const MotionState &next,
                                  const Eigen::MatrixXd &driving) {
          return Eigen::MatrixXd(
            step * (driving - damping_of_step(body, system, next)) + impulse -
            mass_product(body, velocity));
        };
        solve_by_newton(body, system, equations, limits, end, y);
      }
    if (!y.allFinite())
      refuse_step(end, "leads to velocities that are not finite");
    state.velocity = y;
    state.displacement += step * y;
    copy_held(body, there, state.displacement);
    state.time = end;
  }


  GeneralisedAlpha
  generalised_alpha(const double rho)
  {
    GeneralisedAlpha method;
    method.alpha_m = (2. * rho - 1.) / (rho + 1.);
    method.alpha_f = rho / (rho + 1.);
    method.gamma   = 0.5 - method.alpha_m + method.alpha_f;
    method.beta    = 0.25 * std::pow(1. - method.alpha_m + method.alpha_f, 2);
    return method;
  }


  GeneralisedAlpha
  newmark(const double beta, const double gamma)
  {
    return {0., 0., beta, gamma};
  }


  void
  set_acceleration(const MovingBody &body,
                   StepSystem &system,
                   MotionState &state)
  {
    system.linearise(state);
    Eigen::MatrixXd of_held = Eigen::MatrixXd::Zero(state.displacement.rows(),
                                                    state.displacement.cols());
    copy_held(body, state.acceleration, of_held);
    const Eigen::MatrixXd forces = driving_forces(body, state) -
                                   damping_of_step(body, system, state) -
                                   mass_product(body, of_held);
    state.acceleration = of_held + system.solve({1., 0., 0., 0.}, forces);
  }


  void
  generalised_alpha_step(const MovingBody &body,
                         StepSystem &system,
                         const GeneralisedAlpha &method,
                         const NewtonLimits &limits,
                         const double step,
                         MotionState &state)
  {
    const auto [alpha_m, alpha_f, beta, gamma] = method;
    const double end                           = state.time + step;
    const Eigen::MatrixXd there = with_supports(body, end, state.displacement);

    SupportMotion of_supports;
    if (body.support)
      of_supports = motion_of_supports(body, end, 0.05 * step);

    const auto end_of = [&](const Eigen::MatrixXd &acceleration) {
      MotionState next;
      next.time         = end;
      next.acceleration = acceleration;
      next.velocity =
        state.velocity +
        step * ((1. - gamma) * state.acceleration + gamma * acceleration);
      next.displacement =
        state.displacement + step * state.velocity +
        step * step * ((0.5 - beta) * state.acceleration + beta * acceleration);
      copy_held(body, there, next.displacement);
      if (body.support)
        {
          copy_held(body, of_supports.velocity, next.velocity);
          copy_held(body, of_supports.acceleration, next.acceleration);
        }
      return next;
    };

    StepEquations equations;
    const double of_velocity     = (1. - alpha_f) * gamma * step;
    const double of_displacement = (1. - alpha_f) * beta * step * step;
    equations.factors = {1. - alpha_m + of_velocity * body.damping.mass_factor,
                         of_velocity * body.damping.stiffness_factor +
                           of_displacement,
                         of_displacement,
                         of_velocity};
    equations.state   = [&](const Eigen::MatrixXd &acceleration) {
      const MotionState next = end_of(acceleration);
      MotionState between;
      between.time = end - alpha_f * step;
      between.displacement =
        (1. - alpha_f) * next.displacement + alpha_f * state.displacement;
      between.velocity =
        (1. - alpha_f) * next.velocity + alpha_f * state.velocity;
      between.acceleration =
        (1. - alpha_m) * next.acceleration + alpha_m * state.acceleration;
      return between;
    };
    equations.left_over = [&](const Eigen::MatrixXd &,
                              const MotionState &between,
                              const Eigen::MatrixXd &driving) {
      return Eigen::MatrixXd(driving - damping_of_step(body, system, between) -
                             mass_product(body, between.acceleration));
    };
    Eigen::MatrixXd acceleration = state.acceleration;
    solve_by_newton(body, system, equations, limits, end, acceleration);
    state = end_of(acceleration);
  }
} // namespace springfit
