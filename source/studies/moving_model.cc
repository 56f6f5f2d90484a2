#include <springfit/core/error.h>
#include <springfit/motion/integrators.h>
#include <springfit/studies/moving_model.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

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
                           places(excitation, state.displacement),
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

  Eigen::MatrixXd
  places(const Excitation &excitation, const Eigen::MatrixXd &displacement)
  {
    Eigen::MatrixXd x = excitation.nodes + displacement;
    for (std::size_t v = 0; v < excitation.lost_nodes.size(); ++v)
      if (excitation.lost_nodes[v])
        x.col(v).setConstant(std::numeric_limits<double>::infinity());
    return x;
  }

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
                           places(excitation, state.displacement),
                           state.time,
                           forces);
    };
    if (!excitation.obstacles.empty())
      body.load_stiffness = [&](const MotionState &state,
                                Eigen::MatrixXd &blocks) {
        for (const auto &obstacle : excitation.obstacles)
          add_contact_stiffness(obstacle,
                                places(excitation, state.displacement),
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
  go_on_from(const MovingModel &earlier,
             const Excitation &excitation,
             MovingModel &model)
  {
    const auto energy = [](const MovingModel &of) {
      return kinetic_energy(of.body, of.state) +
             elastic_energy(of.body, of.state);
    };
    model.state        = earlier.state;
    model.acceleration = earlier.acceleration;
    for (std::size_t v = 0; v < excitation.lost_nodes.size(); ++v)
      if (excitation.lost_nodes[v])
        for (auto *of_nodes : {&model.state.displacement,
                               &model.state.velocity,
                               &model.state.acceleration,
                               &model.acceleration})
          of_nodes->col(v).setZero();
    set_forces(excitation, model);

    model.account = earlier.account;
    model.account.dissipated += energy(earlier) - energy(model);
    model.seconds       = earlier.seconds;
    model.solutions     = earlier.solutions;
    model.critical_step = earlier.critical_step;
    model.square_sum    = earlier.square_sum;
    model.largest_error = earlier.largest_error;
    model.largest       = earlier.largest;
    model.n_rows        = earlier.n_rows;
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
    const auto &n_iterations = model.system->n_iterations();
    const auto n_before      = n_iterations.size();
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
    model.solutions.n += n_iterations.size() - n_before;
    model.solutions.n_iterations =
      std::accumulate(n_iterations.begin() + n_before,
                      n_iterations.end(),
                      model.solutions.n_iterations);
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
