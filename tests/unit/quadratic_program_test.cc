// Quadratic programs with bounds against other solvers and against what a
// minimiser must satisfy.

#include <springfit/core/error.h>
#include <springfit/fit/programs/ipopt_quadratic.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>
#include <springfit/fit/programs/quadratic_program.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  constexpr int n = 40;

  struct Program
  {
    Eigen::MatrixXd G;
    Eigen::VectorXd g;
  };

  /** Variables of very different units; about half of the bounds hold. */
  Program
  random_program(Random &random)
  {
    const Eigen::MatrixXd A = random.matrix(2 * n, n);
    const Eigen::VectorXd units =
      (8. * random.matrix(n, 1)).unaryExpr([](const double x) {
        return std::exp(x);
      });
    return {units.asDiagonal() * (A.transpose() * A) * units.asDiagonal(),
            units.cwiseProduct(random.matrix(n, 1))};
  }

  const std::vector<bool> free_ones(n, false);
  const std::vector<bool> bounded(n, true);

  /** In units in which the diagonal is one. */
  Eigen::VectorXd
  scaled(const Program &program, const Eigen::VectorXd &x)
  {
    return x.cwiseProduct(program.G.diagonal().cwiseSqrt());
  }

  TEST(QuadraticProgram, WithoutBoundsSolvesTheEquations)
  {
    Random random(301);
    for (int repetition = 0; repetition < 10; ++repetition)
      {
        const Program program = random_program(random);
        const Eigen::VectorXd x =
          minimise_quadratic(program.G, program.g, free_ones);
        // In good units, which that solver needs.
        const Eigen::VectorXd unit =
          program.G.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::MatrixXd G_unit =
          unit.asDiagonal() * program.G * unit.asDiagonal();
        const Eigen::VectorXd exact =
          G_unit.fullPivLu().solve(unit.cwiseProduct(program.g));
        EXPECT_LT((scaled(program, x) - exact).norm(), 1e-10 * exact.norm());
      }
  }

  TEST(QuadraticProgram, AllBoundedIsThatOfLawsonAndHanson)
  {
    Random random(302);
    for (int repetition = 0; repetition < 20; ++repetition)
      {
        const Program program = random_program(random);
        // In good units, which that solver needs.
        const Eigen::VectorXd unit =
          program.G.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::VectorXd expected =
          nonnegative_least_squares(unit.asDiagonal() * program.G *
                                      unit.asDiagonal(),
                                    unit.cwiseProduct(program.g),
                                    n);
        const Eigen::VectorXd x =
          scaled(program, minimise_quadratic(program.G, program.g, bounded));
        EXPECT_GT((expected.array() == 0.).count(), n / 5);
        EXPECT_EQ((x.array() == 0.).count(), (expected.array() == 0.).count());
        EXPECT_LT((x - expected).norm(), 1e-9 * expected.norm());
      }
  }

  TEST(QuadraticProgram, MixedBoundsMeetKarushKuhnAndTucker)
  {
    Random random(303);
    for (int repetition = 0; repetition < 20; ++repetition)
      {
        const Program program = random_program(random);
        std::vector<bool> some(n);
        for (int s = 0; s < n; ++s)
          some[s] = random() < 0.5;
        const Eigen::VectorXd x =
          minimise_quadratic(program.G, program.g, some);
        // Of the same unit as x in scaled().
        const Eigen::VectorXd derivative =
          (program.G * x - program.g)
            .cwiseQuotient(program.G.diagonal().cwiseSqrt());
        int n_held = 0;
        for (int s = 0; s < n; ++s)
          if (some[s] && x[s] == 0.)
            {
              ++n_held;
              EXPECT_GT(derivative[s], -1e-9);
            }
          else
            {
              EXPECT_NEAR(derivative[s], 0., 1e-9);
              EXPECT_TRUE(!some[s] || x[s] > 0.);
            }
        EXPECT_GT(n_held, 0);
      }
  }

  TEST(QuadraticProgram, SparseIsDense)
  {
    Random random(304);
    const Program program               = random_program(random);
    const Eigen::SparseMatrix<double> G = program.G.sparseView();
    for (const auto &flags : {free_ones, bounded})
      {
        const Eigen::VectorXd dense =
          scaled(program, minimise_quadratic(program.G, program.g, flags));
        const Eigen::VectorXd sparse =
          scaled(program, minimise_quadratic(G, program.g, flags));
        EXPECT_LT((dense - sparse).norm(), 1e-10 * dense.norm());
      }
  }

  /** Where the active sets cycle it is Ipopt that finds them. */
  TEST(QuadraticProgram, IpoptComesNear)
  {
    Random random(305);
    for (int repetition = 0; repetition < 5; ++repetition)
      {
        Program program = random_program(random);
        const Eigen::VectorXd unit =
          program.G.diagonal().cwiseSqrt().cwiseInverse();
        program.G = (unit.asDiagonal() * program.G * unit.asDiagonal()).eval();
        program.g = program.g.cwiseProduct(unit).normalized();
        const Eigen::VectorXd expected =
          nonnegative_least_squares(program.G, program.g, n);
        const Eigen::VectorXd x = minimise_by_ipopt(program.G.sparseView(),
                                                    program.g,
                                                    bounded,
                                                    Eigen::VectorXd::Zero(n));
        EXPECT_LT((x - expected).norm(), 1e-6 * expected.norm());
      }
  }

  TEST(QuadraticProgram, SmallestOfEqualMinimisers)
  {
    // Three variables of which only the sum counts.
    const Eigen::MatrixXd G = Eigen::MatrixXd::Ones(3, 3);
    const Eigen::VectorXd x =
      minimise_quadratic(G, Eigen::Vector3d(6., 6., 6.), {false, false, false});
    EXPECT_LT((x - Eigen::Vector3d(2., 2., 2.)).norm(), 1e-6);
  }

  TEST(QuadraticProgram, NothingToFitIsZero)
  {
    const Eigen::MatrixXd G = Eigen::MatrixXd::Identity(2, 2);
    EXPECT_EQ(minimise_quadratic(G, Eigen::Vector2d::Zero(), {true, false}),
              Eigen::Vector2d::Zero());
  }

  TEST(QuadraticProgram, WhatHasNoMinimiserIsAnError)
  {
    const double nan            = std::numeric_limits<double>::quiet_NaN();
    const std::vector<bool> any = {false, true};
    Eigen::MatrixXd G           = Eigen::MatrixXd::Identity(2, 2);
    EXPECT_THROW(minimise_quadratic(G, Eigen::Vector2d(1., nan), any),
                 RunError);
    G(1, 1) = 0.;
    EXPECT_THROW(minimise_quadratic(G, Eigen::Vector2d(1., 1.), any), RunError);
    G << 1., 2., 2., 1.; // indefinite
    EXPECT_THROW(minimise_quadratic(G, Eigen::Vector2d(1., 0.), any), RunError);
    G << 1., 1., 1., 1.; // falls forever along (1, -1)
    EXPECT_THROW(minimise_quadratic(G,
                                    Eigen::Vector2d(1., -1.),
                                    {false, false}),
                 RunError);
  }
} // namespace
