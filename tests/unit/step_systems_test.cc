// Conjugate gradients against factors: the same solutions, with held unknowns,
// for every family of springs, and iterations that hardly depend on the size.

#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/motion/direct_step_system.h>
#include <springfit/motion/integrators.h>
#include <springfit/motion/iterative_step_system.h>
#include <springfit/motion/step_matrix.h>
#include <springfit/motion/step_systems.h>
#include <springfit/response/network_body.h>
#include <springfit/springs/network.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
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
  MotionState
  at(const Eigen::MatrixXd &displacement)
  {
    MotionState state;
    state.displacement = displacement;
    state.velocity     = 0. * displacement;
    return state;
  }

  using Model = std::function<Families(const FitProblem &)>;

  /** Every family there is in space, by what it is of. */
  const std::map<std::string, Model> &
  models()
  {
    static const std::map<std::string, Model> all = [] {
      std::map<std::string, Model> models;
      for (const SpringLaw law : {SpringLaw::quadratic, SpringLaw::biquadratic})
        for (const Enrichment enrichment : {Enrichment::none,
                                            Enrichment::volume,
                                            Enrichment::angles,
                                            Enrichment::coupling})
          models[word_of(spring_law_words(), law) + ' ' +
                 word_of(enrichment_words(), enrichment)] =
            [law, enrichment](FitProblem problem) {
              problem.law = law;
              return unit_families(problem, enrichment);
            };
      for (const VolumeLaw law : {VolumeLaw::quadratic, VolumeLaw::logarithmic})
        {
          const std::string word = word_of(volume_law_words(), law);
          models["stable neo-hookean volume " + word] =
            [law](const FitProblem &problem) {
              return fit_stable_neo_hookean_volume(problem, law).families;
            };
          models["stable neo-hookean points " + word] =
            [law](const FitProblem &problem) {
              return fit_stable_neo_hookean_points(problem, law).families;
            };
        }
      return models;
    }();
    return all;
  }

  /** A cube of n^3 cells whose face z = 0 is held, and a state of it. */
  struct Example
  {
    Example(const unsigned int n, const Model &model)
      : nodes(places(n)), network(nodes, families(n, nodes, model))
    {
      body.elastic = &network;
      body.mass    = Eigen::VectorXd::Constant(nodes.cols(), 0.3);
      body.held.assign(nodes.size(), false);
      for (unsigned int v = 0; v < nodes.cols(); ++v)
        for (int d = 0; d < 3; ++d)
          body.held[3 * v + d] = nodes(2, v) == 0. || (d == 0 && v % 7 == 0);
      // Stretched, so that springs pull.
      displacement = 0.1 * nodes;
    }

    static Eigen::MatrixXd
    places(const unsigned int n)
    {
      const unsigned int m = n + 1;
      Eigen::MatrixXd nodes(3, m * m * m);
      for (unsigned int v = 0; v < nodes.cols(); ++v)
        nodes.col(v) << v % m, v / m % m, v / m / m;
      return nodes;
    }

    static Families
    families(const unsigned int n,
             const Eigen::MatrixXd &nodes,
             const Model &model)
    {
      const unsigned int m = n + 1;
      NetworkBuilder builder(nodes);
      for (unsigned int v = 0; v < nodes.cols(); ++v)
        {
          if (nodes.col(v).maxCoeff() == n)
            continue;
          std::vector<unsigned int> cell;
          for (unsigned int c = 0; c < 8; ++c)
            cell.push_back(v + (c & 1) + m * (c >> 1 & 1) +
                           m * m * (c >> 2 & 1));
          const auto problem = make_fit_problem(nodes(Eigen::all, cell),
                                                CellKind::hexahedron,
                                                Eigen::MatrixXd::Zero(24, 24),
                                                {1., 0.3, 1.});
          for (const Family &family : model(problem))
            builder.add(family, cell);
        }
      return builder.build().families;
    }

    Example(const Example &) = delete;

    Eigen::MatrixXd nodes;
    NetworkBody network;
    MovingBody body;
    Eigen::MatrixXd displacement;
  };

  constexpr double tolerance = 1e-9;

  std::map<std::string, std::unique_ptr<StepPreconditioner>>
  preconditioners(const MovingBody &body)
  {
    std::map<std::string, std::unique_ptr<StepPreconditioner>> all;
    all["multigrid"] = multigrid_preconditioner(3, body);
    all["factors"]   = factor_preconditioner(3, body);
    return all;
  }

  void
  set_held_to_zero(const MovingBody &body, Eigen::MatrixXd &values)
  {
    copy_held(body,
              Eigen::MatrixXd::Zero(values.rows(), values.cols()),
              values);
  }
} // namespace

TEST(StepSystems, by_iterations_solve_as_by_factors)
{
  for (const auto &[name, model] : models())
    {
      SCOPED_TRACE(name);
      Example example(3, model);
      DirectStepSystem direct(3, example.body);
      direct.linearise(at(example.displacement));
      for (const auto life :
           {PreconditionerLife::short_one, PreconditionerLife::long_one})
        for (auto &[word, preconditioner] : preconditioners(example.body))
          {
            SCOPED_TRACE(word);
            IterativeStepSystem system(
              3, example.body, std::move(preconditioner), life, tolerance);
            system.linearise(at(example.displacement));
            Random random(5);
            // The second begins with a guess, the third has other factors.
            for (const double stiffness_factor : {2., 2., 0.1})
              {
                Eigen::MatrixXd forces = random.matrix(3, example.nodes.cols());
                const Eigen::MatrixXd exact =
                  direct.solve({1.1, stiffness_factor, 0., 0.}, forces);
                const Eigen::MatrixXd solution =
                  system.solve({1.1, stiffness_factor, 0., 0.}, forces);
                EXPECT_LT((solution - exact).norm(), 1e-6 * exact.norm());
                Eigen::MatrixXd rest =
                  forces - 1.1 * solution * example.body.mass.asDiagonal() -
                  stiffness_factor * direct.stiffness_product(solution);
                set_held_to_zero(example.body, rest);
                set_held_to_zero(example.body, forces);
                EXPECT_LT(rest.norm(), 2. * tolerance * forces.norm());
                for (std::size_t i = 0; i < example.body.held.size(); ++i)
                  if (example.body.held[i])
                    {
                      EXPECT_EQ(solution.reshaped()[i], 0.);
                    }
              }
          }
    }
}

TEST(StepSystems, count_loads_dampers_and_consistent_masses)
{
  Example example(3, models().at("quadratic none"));
  MovingBody &body         = example.body;
  const Eigen::Index n     = example.nodes.cols();
  body.dampers.coefficient = 0.7;
  body.dampers.nodes       = example.nodes;
  for (unsigned int v = 0; v + 1 < n; ++v)
    body.dampers.pairs.push_back({v, v + 1});
  Random random(4);
  Eigen::MatrixXd of_nodes    = Eigen::MatrixXd::Zero(n, n);
  of_nodes.diagonal(1)        = random.matrix(1, n - 1).transpose() * 0.04;
  of_nodes                    = (of_nodes + of_nodes.transpose()).eval();
  of_nodes.diagonal().array() = 0.3;
  body.consistent_mass        = of_nodes.sparseView();
  Eigen::MatrixXd pressing    = Eigen::MatrixXd::Zero(3, 3 * n);
  for (const unsigned int v : {40, 41, 57})
    {
      const Eigen::VectorXd normal  = random.matrix(3, 1);
      pressing.middleCols(3 * v, 3) = 50. * normal * normal.transpose();
    }
  body.load_stiffness = [&](const MotionState &, Eigen::MatrixXd &blocks) {
    blocks += pressing;
  };

  const MotionState state = at(example.displacement);
  TangentMatrix stiffness(3, step_pattern(body));
  example.network.add_tangent(state.displacement, stiffness);
  const StepFactors factors = {1.2, 0.4, 0.3, 0.2};
  Eigen::MatrixXd A         = factors.stiffness * stiffness.matrix();
  for (Eigen::Index i = 0; i < 3 * n; ++i)
    {
      Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(3, n);
      unit(i % 3, i / 3)   = 1.;
      const Eigen::MatrixXd of_unit =
        factors.mass * unit * of_nodes +
        factors.dampers *
          damper_product(body.dampers, state.displacement, unit);
      A.col(i) += of_unit.reshaped();
      A.col(i).segment(i / 3 * 3, 3) +=
        factors.load_stiffness * pressing.col(i);
    }
  std::vector<int> free;
  for (std::size_t i = 0; i < body.held.size(); ++i)
    if (!body.held[i])
      free.push_back(i);
  const Eigen::MatrixXd forces = random.matrix(3, n);
  const Eigen::VectorXd exact =
    A(free, free).llt().solve(forces.reshaped()(free));

  const auto expect_exact = [&](StepSystem &system) {
    system.linearise(state);
    const Eigen::MatrixXd solution = system.solve(factors, forces);
    EXPECT_LT((solution.reshaped()(free) - exact).norm(), 1e-7 * exact.norm());
  };
  DirectStepSystem direct(3, body);
  expect_exact(direct);
  for (const auto life :
       {PreconditionerLife::short_one, PreconditionerLife::long_one})
    for (auto &[word, preconditioner] : preconditioners(body))
      {
        SCOPED_TRACE(word);
        IterativeStepSystem system(
          3, body, std::move(preconditioner), life, tolerance);
        expect_exact(system);
        // Factors of the whole matrix leave little to do.
        if (word == "factors" && life == PreconditionerLife::short_one)
          {
            EXPECT_LE(system.n_iterations().back(), 3u);
          }
      }
}

TEST(StepSystems, multiply_as_the_tangent_does)
{
  for (const auto &[name, model] : models())
    {
      SCOPED_TRACE(name);
      Random random(3);
      Example example(2, model);
      const Eigen::MatrixXd there =
        example.displacement + 0.05 * random.matrix(3, example.nodes.cols());
      const Eigen::MatrixXd u = random.matrix(3, example.nodes.cols());
      DirectStepSystem direct(3, example.body);
      direct.linearise(at(there));
      const Eigen::MatrixXd exact = direct.stiffness_product(u);
      const auto system           = make_step_system(3, example.body).system;
      system->linearise(at(there));
      EXPECT_LT((system->stiffness_product(u) - exact).norm(),
                1e-12 * exact.norm());
      Eigen::MatrixXd product = Eigen::MatrixXd::Zero(3, u.cols());
      example.network.add_tangent_product(there, u, product);
      EXPECT_LT((product - exact).norm(), 1e-12 * exact.norm());
    }
}

TEST(StepSystems, take_as_many_iterations_on_all_sizes)
{
  for (const std::string name :
       {"quadratic none", "stable neo-hookean volume quadratic"})
    {
      SCOPED_TRACE(name);
      std::map<unsigned int, unsigned int> n_iterations;
      for (const unsigned int n : {4, 8})
        {
          Example example(n, models().at(name));
          IterativeStepSystem system(3,
                                     example.body,
                                     multigrid_preconditioner(3, example.body));
          system.linearise(at(example.displacement));
          Random random(n);
          // A step so large that the masses hardly count.
          system.solve({1., 1e3, 0., 0.},
                       random.matrix(3, example.nodes.cols()));
          n_iterations[n] = system.n_iterations().back();
        }
      EXPECT_LE(n_iterations[8], 1.8 * n_iterations[4]);
      EXPECT_LE(n_iterations[8], 50u);
    }
}

TEST(StepSystems, solve_what_is_not_positive_definite)
{
  Example example(3, models().at("quadratic none"));
  const Eigen::MatrixXd pressed = -0.5 * example.nodes;
  const auto system = make_step_system(3, example.body, tolerance).system;
  DirectStepSystem direct(3, example.body);
  Random random(8);
  const Eigen::MatrixXd forces = random.matrix(3, example.nodes.cols());
  system->linearise(at(pressed));
  direct.linearise(at(pressed));
  const Eigen::MatrixXd exact = direct.solve({0.1, 10., 0., 0.}, forces);
  EXPECT_LT((system->solve({0.1, 10., 0., 0.}, forces) - exact).norm(),
            1e-8 * exact.norm());
}

TEST(StepSystems, take_the_convex_tangent_where_told)
{
  Example example(3, models().at("quadratic none"));
  const MotionState pressed = at(-0.5 * example.nodes);
  StepMatrix matrix(3, example.body);
  matrix.linearise(pressed, Tangent::convex);
  const StepFactors factors = {0.1, 10., 0., 0.};
  const Eigen::MatrixXd A(matrix.sum(factors));
  Random random(8);
  Eigen::MatrixXd forces = random.matrix(3, example.nodes.cols());
  set_held_to_zero(example.body, forces);
  const Eigen::VectorXd exact = A.llt().solve(forces.reshaped());
  for (const auto life :
       {PreconditionerLife::short_one, PreconditionerLife::long_one})
    for (auto &[word, preconditioner] : preconditioners(example.body))
      {
        SCOPED_TRACE(word);
        IterativeStepSystem system(3,
                                   example.body,
                                   std::move(preconditioner),
                                   life,
                                   tolerance,
                                   WhereIndefinite::convex_tangent);
        system.linearise(pressed);
        EXPECT_LT((system.solve(factors, forces).reshaped() - exact).norm(),
                  1e-6 * exact.norm());
      }
}

TEST(StepSystems, hand_on_forces_that_are_not_finite)
{
  Example example(2, models().at("quadratic none"));
  const auto system = make_step_system(3, example.body).system;
  system->linearise(at(example.displacement));
  Eigen::MatrixXd forces = Eigen::MatrixXd::Ones(3, example.nodes.cols());
  forces.reshaped().tail(1).setConstant(
    std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(system->solve({1., 1., 0., 0.}, forces).allFinite());
}

TEST(StepSystems, resemble_the_matrix_with_a_scalar_one)
{
  for (const std::string name :
       {"quadratic none", "stable neo-hookean volume quadratic"})
    {
      SCOPED_TRACE(name);
      Example example(3, models().at(name));
      const Eigen::MatrixXd rest =
        Eigen::MatrixXd::Zero(3, example.nodes.cols());
      StepMatrix matrix(3, example.body);
      matrix.linearise(at(rest), Tangent::exact);
      const Eigen::MatrixXd A(matrix.sum({1., 5., 0., 0.}));
      const Eigen::MatrixXd S(
        scalar_step_matrix(3, example.body, rest, 1., 5.));
      EXPECT_EQ(S, S.transpose());
      // On free unknowns S on each component is between multiples of A.
      std::vector<int> free;
      for (std::size_t i = 0; i < example.body.held.size(); ++i)
        if (!example.body.held[i])
          free.push_back(i);
      Eigen::MatrixXd on_components = Eigen::MatrixXd::Zero(A.rows(), A.cols());
      for (int i = 0; i < A.rows(); ++i)
        for (int j = 0; j < A.cols(); ++j)
          if (i % 3 == j % 3)
            on_components(i, j) = S(i / 3, j / 3);
      const Eigen::VectorXd ratios =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
          A(free, free), on_components(free, free), Eigen::EigenvaluesOnly)
          .eigenvalues();
      EXPECT_GT(ratios.minCoeff(), 0.1);
      EXPECT_LT(ratios.maxCoeff(), 5.);
    }
}

TEST(StepSystems, choose_factors_for_small_bodies_alone)
{
  const Model springs = models().at("quadratic none");
  Example small(2, springs), large(8, springs);
  EXPECT_NE(make_step_system(3, small.body).reason.find("each step's matrix"),
            std::string::npos);
  EXPECT_NE(make_step_system(3, large.body).reason.find("multigrid"),
            std::string::npos);
}
