// Integrators against motions that are known: an oscillator, free fall, what is
// conserved, a support that moves.

#include <springfit/core/error.h>
#include <springfit/motion/contact.h>
#include <springfit/motion/direct_step_system.h>
#include <springfit/motion/integrators.h>
#include <springfit/motion/largest_mode.h>
#include <springfit/response/network_body.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/rest_families.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  using Step = std::function<
    void(const MovingBody &, StepSystem &, double, MotionState &)>;

  const NewtonLimits tight = {1e-13, 30};

  const std::map<std::string, Step> &
  steps()
  {
    static const std::map<std::string, Step> all = {
      {"symplectic Euler", symplectic_euler_step},
      {"implicit Euler",
       [](const auto &body, auto &system, const double h, auto &state) {
         implicit_euler_step(body, system, tight, h, state);
       }},
      {"one linearisation",
       [](const auto &body, auto &system, const double h, auto &state) {
         implicit_euler_step(body, system, {1e-6, 1}, h, state);
       }},
      {"trapezoidal rule",
       [](const auto &body, auto &system, const double h, auto &state) {
         generalised_alpha_step(
           body, system, newmark(0.25, 0.5), tight, h, state);
       }},
      {"generalised alpha",
       [](const auto &body, auto &system, const double h, auto &state) {
         generalised_alpha_step(
           body, system, generalised_alpha(0.5), tight, h, state);
       }}};
    return all;
  }

  /** A network that moves, with what it refers to. */
  struct Example
  {
    Example(const Eigen::MatrixXd &nodes, Families families)
      : network(nodes, std::move(families))
    {
      body.elastic       = &network;
      body.mass          = Eigen::VectorXd::Constant(nodes.cols(), 0.3);
      body.held          = std::vector<bool>(nodes.size(), false);
      body.rounding      = 1e-12;
      state.displacement = state.velocity = state.acceleration =
        Eigen::MatrixXd::Zero(nodes.rows(), nodes.cols());
    }

    void
    run(const Step &step, const double time, const unsigned int n)
    {
      DirectStepSystem system(state.displacement.rows(), body);
      set_acceleration(body, system, state);
      for (unsigned int i = 0; i < n; ++i)
        step(body, system, time / n, state);
    }

    NetworkBody network;
    MovingBody body;
    MotionState state;
  };

  constexpr double stiffness = 2.7, mass = 0.3; // rad/s 3

  /** A mass on a spring along x whose other end is held. */
  Example
  oscillator()
  {
    Eigen::MatrixXd nodes(3, 2);
    nodes << 0., 1., 0., 0., 0., 0.;
    const Eigen::VectorXd k = Eigen::VectorXd::Constant(1, stiffness);
    Example example(
      nodes, {lengths_at_rest(nodes, {{0, 1}}, k, SpringLaw::quadratic)});
    for (unsigned int i : {0, 1, 2, 4, 5})
      example.body.held[i] = true;
    return example;
  }

  /** A random cell of springs and a volume that nothing holds. */
  Example
  free_cell(const CellKind kind, Random &random)
  {
    const Eigen::MatrixXd nodes = oracle::random_cell(kind, random);
    const auto pairs            = node_pairs(kind);
    Example example(nodes,
                    {lengths_at_rest(nodes,
                                     pairs,
                                     Eigen::VectorXd::Ones(pairs.size()),
                                     SpringLaw::quadratic),
                     volume_at_rest(nodes, kind, 2.)});
    for (double &m : example.body.mass)
      m = random(0.5, 2.);
    for (double &v : example.state.velocity.reshaped())
      v = random(-0.3, 0.3);
    return example;
  }

  /** Of motions in the plane z; kg m^2/s */
  double
  angular_momentum(const Eigen::MatrixXd &nodes, const Example &example)
  {
    const Eigen::MatrixXd x  = nodes + example.state.displacement;
    const Eigen::MatrixXd &v = example.state.velocity;
    return (x.row(0).cwiseProduct(v.row(1)) - x.row(1).cwiseProduct(v.row(0))) *
           example.body.mass;
  }
} // namespace

TEST(Integrators, have_their_orders)
{
  const std::map<std::string, double> orders = {{"symplectic Euler", 1.},
                                                {"implicit Euler", 1.},
                                                {"one linearisation", 1.},
                                                {"trapezoidal rule", 2.},
                                                {"generalised alpha", 2.}};
  const double frequency = std::sqrt(stiffness / mass), time = 2.;
  for (const double damping : {0., 0.8})
    {
      const double decay = 0.5 * damping;
      const double omega = std::sqrt(frequency * frequency - decay * decay);
      // x(0) = 0.05, v(0) = 0.1
      const double exact =
        std::exp(-decay * time) *
        (0.05 * std::cos(omega * time) +
         (0.1 + 0.05 * decay) / omega * std::sin(omega * time));
      for (const auto &[name, step] : steps())
        {
          SCOPED_TRACE(name);
          std::vector<double> errors;
          for (const unsigned int n : {400u, 800u})
            {
              Example example                  = oscillator();
              example.body.damping.mass_factor = damping;
              example.state.velocity(0, 1)     = 0.1;
              example.state.displacement(0, 1) = 0.05;
              example.run(step, time, n);
              errors.push_back(
                std::abs(example.state.displacement(0, 1) - exact));
            }
          EXPECT_NEAR(std::log2(errors[0] / errors[1]), orders.at(name), 0.1);
        }
    }
}

TEST(Integrators, damp_by_stiffness_as_rayleigh_says)
{
  const double frequency = std::sqrt(stiffness / mass), time = 2.;
  for (const auto &[name, step] : steps())
    {
      SCOPED_TRACE(name);
      Example example                       = oscillator();
      example.body.damping.stiffness_factor = 0.1;
      example.state.velocity(0, 1)          = 0.1;
      example.run(step, time, 20000);
      const double decay =
        frequency * damping_ratio(example.body.damping, frequency);
      const double omega = std::sqrt(frequency * frequency - decay * decay);
      EXPECT_NEAR(example.state.displacement(0, 1),
                  0.1 / omega * std::exp(-decay * time) *
                    std::sin(omega * time),
                  2e-5);
    }
}

TEST(Integrators, symplectic_euler_keeps_its_energy)
{
  Random random(2);
  Example example = free_cell(CellKind::tetrahedron, random);
  DirectStepSystem system(3, example.body);
  const auto energy = [&]() {
    return kinetic_energy(example.body, example.state) +
           elastic_energy(example.body, example.state);
  };
  const double begin = energy();
  double low = begin, high = begin;
  for (unsigned int i = 0; i < 100000; ++i)
    {
      symplectic_euler_step(example.body, system, 0.02, example.state);
      low  = std::min(low, energy());
      high = std::max(high, energy());
    }
  EXPECT_GT(low, 0.97 * begin);
  EXPECT_LT(high, 1.03 * begin);
}

TEST(Integrators, conserve_momentum_and_symplectic_euler_its_moment)
{
  Random random(4);
  for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
    for (const auto &[name, step] : steps())
      {
        SCOPED_TRACE(name);
        Random same(9);
        const Eigen::MatrixXd nodes = oracle::random_cell(kind, same);
        Random again(9);
        Example example             = free_cell(kind, again);
        const Eigen::VectorXd begin = momentum(example.body, example.state);
        const double moment         = angular_momentum(nodes, example);
        example.run(step, 3., 300);
        EXPECT_LT((momentum(example.body, example.state) - begin).norm(),
                  1e-9 * begin.norm());
        if (name == "symplectic Euler")
          EXPECT_NEAR(angular_momentum(nodes, example),
                      moment,
                      1e-11 * std::abs(moment));
      }
}

TEST(Integrators, of_second_order_fall_exactly)
{
  for (const std::string name : {"trapezoidal rule", "generalised alpha"})
    {
      Random random(6);
      Example example = free_cell(CellKind::tetrahedron, random);
      example.state.velocity.setZero();
      example.body.loads = [&](const MotionState &, Eigen::MatrixXd &forces) {
        forces.row(2) -= 9.81 * example.body.mass.transpose();
      };
      example.run(steps().at(name), 1.5, 30);
      for (unsigned int v = 0; v < 4; ++v)
        EXPECT_NEAR(example.state.displacement(2, v),
                    -0.5 * 9.81 * 1.5 * 1.5,
                    1e-9);
    }
}

// At a tenth of its frequency the mass follows the support by the factor
// 1 / (1 - 1/100), with its own motion from the start on top.
TEST(Integrators, follow_a_support_that_moves)
{
  const double frequency = std::sqrt(stiffness / mass), drive = 0.1 * frequency;
  const double factor = 1. / (1. - 0.01), time = 7.;
  const double exact =
    0.02 * factor *
    (std::sin(drive * time) - drive / frequency * std::sin(frequency * time));
  for (const auto &[name, step] : steps())
    {
      SCOPED_TRACE(name);
      Example example      = oscillator();
      example.body.support = [&](const double t, Eigen::MatrixXd &there) {
        there(0, 0) = 0.02 * std::sin(drive * t);
      };
      example.run(step, time, 20000);
      EXPECT_NEAR(example.state.displacement(0, 1), exact, 2e-5);
      EXPECT_NEAR(example.state.displacement(0, 0),
                  0.02 * std::sin(drive * time),
                  1e-13);
    }
}

TEST(Integrators, refuse_a_step_that_does_not_converge)
{
  Example example    = oscillator();
  example.body.loads = [](const MotionState &, Eigen::MatrixXd &forces) {
    forces(0, 1) = std::numeric_limits<double>::quiet_NaN();
  };
  DirectStepSystem system(3, example.body);
  for (const std::string name : {"implicit Euler", "trapezoidal rule"})
    EXPECT_THROW(steps().at(name)(example.body, system, 0.1, example.state),
                 RunError);
}

TEST(Integrators, damp_by_dampers_as_theory_says)
{
  // One damper along the spring: c x' beside k x.
  const double frequency = std::sqrt(stiffness / mass), time = 2., c = 0.24;
  for (const auto &[name, step] : steps())
    {
      SCOPED_TRACE(name);
      Example example      = oscillator();
      example.body.dampers = {c, {{{0, 1}}}, Eigen::MatrixXd::Zero(3, 2)};
      example.body.dampers.nodes(0, 1) = 1.;
      example.state.velocity(0, 1)     = 0.1;
      example.run(step, time, 20000);
      const double decay = 0.5 * c / mass;
      const double omega = std::sqrt(frequency * frequency - decay * decay);
      EXPECT_NEAR(example.state.displacement(0, 1),
                  0.1 / omega * std::exp(-decay * time) *
                    std::sin(omega * time),
                  2e-5);
    }
}

TEST(Integrators, bounce_off_obstacles_as_half_an_oscillation)
{
  // A mass of speed v meets a stiffness k: it is inside for pi sqrt(m / k) and
  // leaves with - v. The way through a plane is that through a sphere's pole.
  const double k = 50., speed = 0.4;
  Plane floor{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()};
  Sphere ball{Eigen::Vector3d(0., 0., -2.), 2.};
  for (const Shape &shape : {Shape(floor), Shape(ball)})
    for (const auto &[name, step] : steps())
      {
        SCOPED_TRACE(name);
        Example example(Eigen::MatrixXd::Zero(3, 1), {});
        const Obstacle obstacle{"", [&](double) { return shape; }, k};
        example.body.loads = [&](const MotionState &state,
                                 Eigen::MatrixXd &forces) {
          add_contact_forces(obstacle, state.displacement, state.time, forces);
        };
        example.body.load_stiffness = [&](const MotionState &state,
                                          Eigen::MatrixXd &blocks) {
          add_contact_stiffness(obstacle,
                                state.displacement,
                                state.time,
                                blocks);
        };
        example.state.displacement(2, 0) = 0.1;
        example.state.velocity(2, 0)     = -speed;
        const double inside              = M_PI * std::sqrt(mass / k);
        const double time                = 0.25 + inside + 0.25;
        example.run(step, time, 40000);
        EXPECT_NEAR(example.state.velocity(2, 0), speed, 2e-3 * speed);
        EXPECT_NEAR(example.state.displacement(2, 0), 0.1, 2e-3 * 0.1);
      }
}

TEST(Integrators, stay_at_an_obstacle_that_leaves)
{
  // A stiff plane presses the mass 0.1 m along the spring and goes back,
  // slowly: its force is the spring's, though in a step it moves by many times
  // the depth of the mass inside. It begins to move at once, which takes an
  // impulse.
  const double omega = 0.5, h = 0.05;
  const Obstacle plane{
    "",
    [&](const double t) {
      const double x = 1. - 0.1 * std::abs(std::sin(omega * t));
      return Plane{Eigen::Vector3d(x, 0., 0.), -Eigen::Vector3d::UnitX()};
    },
    2000.};
  Eigen::MatrixXd nodes(3, 2);
  nodes << 0., 1., 0., 0., 0., 0.;
  for (const std::string name : {"one linearisation", "implicit Euler"})
    {
      SCOPED_TRACE(name);
      Example example    = oscillator();
      example.body.loads = [&](const MotionState &state,
                               Eigen::MatrixXd &forces) {
        add_contact_forces(plane,
                           nodes + state.displacement,
                           state.time,
                           forces);
      };
      example.body.load_stiffness = [&](const MotionState &state,
                                        Eigen::MatrixXd &blocks) {
        add_contact_stiffness(plane,
                              nodes + state.displacement,
                              state.time,
                              blocks);
      };
      DirectStepSystem system(3, example.body);
      for (unsigned int i = 1; i * h < M_PI / omega; ++i)
        {
          steps().at(name)(example.body, system, h, example.state);
          Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(3, 2);
          example.body.loads(example.state, forces);
          if (i > 4)
            {
              EXPECT_NEAR(forces(0, 1),
                          -0.1 * stiffness * std::sin(omega * i * h),
                          0.1 * 0.1 * stiffness)
                << "at t = " << i * h;
            }
        }
    }
}

TEST(Integrators, move_a_consistent_mass)
{
  // A bar of two masses, M = m [2 1; 1 2] / 6 each component, free at one end:
  // the free end's frequency is sqrt(k / (m / 3)).
  const double frequency = std::sqrt(3. * stiffness / mass), time = 2.;
  for (const auto &[name, step] : steps())
    {
      if (name == "symplectic Euler")
        continue; // which has lumped masses
      SCOPED_TRACE(name);
      Example example = oscillator();
      Eigen::MatrixXd M(2, 2);
      M << 2., 1., 1., 2.;
      example.body.consistent_mass = (mass / 6. * M).sparseView();
      example.state.velocity(0, 1) = 0.1;
      example.run(step, time, 20000);
      EXPECT_NEAR(example.state.displacement(0, 1),
                  0.1 / frequency * std::sin(frequency * time),
                  5e-5);
    }
}
