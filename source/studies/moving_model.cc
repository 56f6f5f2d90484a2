#include <springfit/core/error.h>
#include <springfit/motion/integrators.h>
#include <springfit/studies/moving_model.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace springfit
{
  namespace
  {
    Eigen::MatrixXd
    contact_forces(const Excitation &excitation, const MotionState &state)
    {
      Eigen::MatrixXd forces =
        Eigen::MatrixXd::Zero(excitation.nodes.rows(), excitation.nodes.cols());
      for (const auto &obstacle : excitation.obstacles)
        add_contact_forces(obstacle,
                           excitation.nodes + state.displacement,
                           state.time,
                           forces);
      return forces;
    }

    ForcesInMotion
    forces_in_motion(const Excitation &excitation, const MovingModel &model)
    {
      return {excitation.load(model.state.time).forces,
              contact_forces(excitation, model.state),
              damping_forces(model.body, model.state),
              reactions_in_motion(model.body, model.state, model.acceleration)};
    }

    template <int dim>
    void
    step_by(const DynamicsSettings<dim> &settings,
            const double step,
            MovingModel &model)
    {
      switch (settings.integrator)
        {
          case Integrator::implicit_euler:
            return implicit_euler_step(
              model.body, *model.system, settings.newton, step, model.state);
          case Integrator::symplectic_euler:
            return symplectic_euler_step(model.body,
                                         *model.system,
                                         step,
                                         model.state);
          case Integrator::generalised_alpha:
          case Integrator::newmark:
            return generalised_alpha_step(model.body,
                                          *model.system,
                                          settings.method,
                                          settings.newton,
                                          step,
                                          model.state);
        }
    }
  } // namespace

  void
  start(const double time,
        const double interval,
        const Excitation &excitation,
        MovingModel &model)
  {
    auto &body = model.body;
    body.held  = excitation.held;
    body.loads = [&](const MotionState &state, Eigen::MatrixXd &forces) {
      forces += excitation.load(state.time).forces;
      for (const auto &obstacle : excitation.obstacles)
        add_contact_forces(obstacle,
                           excitation.nodes + state.displacement,
                           state.time,
                           forces);
    };
    if (!excitation.obstacles.empty())
      body.load_stiffness = [&](const MotionState &state,
                                Eigen::MatrixXd &blocks) {
        for (const auto &obstacle : excitation.obstacles)
          add_contact_stiffness(obstacle,
                                excitation.nodes + state.displacement,
                                state.time,
                                blocks);
      };
    body.largest_load_stiffness = 0.;
    for (const auto &obstacle : excitation.obstacles)
      body.largest_load_stiffness += obstacle.stiffness;
    body.support = [&](const double t, Eigen::MatrixXd &displacement) {
      displacement = excitation.load(t).support;
    };

    const Eigen::MatrixXd rest =
      Eigen::MatrixXd::Zero(excitation.nodes.rows(), excitation.nodes.cols());
    model.state              = {time, rest, rest, rest};
    model.state.displacement = with_supports(body, time, rest);
    copy_held(body,
              (with_supports(body, time + interval, rest) -
               model.state.displacement) /
                interval,
              model.state.velocity);
    model.acceleration = rest;
    set_forces(excitation, model);
  }

  void
  set_forces(const Excitation &excitation, MovingModel &model)
  {
    model.forces = forces_in_motion(excitation, model);
  }

  template <int dim>
  void
  advance(const DynamicsSettings<dim> &settings,
          const double step,
          const double end,
          const Excitation &excitation,
          MovingModel &model)
  {
    using Clock              = std::chrono::steady_clock;
    const MotionState before = model.state;
    const auto begin         = Clock::now();
    try
      {
        step_by(settings, step, model);
      }
    catch (...)
      {
        model.state = before;
        throw;
      }
    model.seconds +=
      std::chrono::duration<double>(Clock::now() - begin).count();
    if (!model.state.velocity.allFinite() ||
        !std::isfinite(elastic_energy(model.body, model.state)))
      {
        model.state = before;
        throw RunError("the motion has no finite velocity or energy after the "
                       "step.",
                       "Choose a smaller step.");
      }
    model.state.time = end;
    model.acceleration =
      settings.integrator == Integrator::generalised_alpha ||
          settings.integrator == Integrator::newmark
        ? model.state.acceleration
        : Eigen::MatrixXd((model.state.velocity - before.velocity) / step);
    const ForcesInMotion forces = forces_in_motion(excitation, model);
    add_step(before, model.forces, model.state, forces, model.account);
    model.forces = forces;
  }

  template void
  advance(const DynamicsSettings<2> &,
          double,
          double,
          const Excitation &,
          MovingModel &);
  template void
  advance(const DynamicsSettings<3> &,
          double,
          double,
          const Excitation &,
          MovingModel &);
} // namespace springfit
