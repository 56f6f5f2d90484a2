// Least squares near a prior against dense linear algebra and the active set
// method of cells.

#include <springfit/core/error.h>
#include <springfit/fit/programs/bounded_least_squares.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  constexpr int n = 40;

  struct Problem
  {
    Eigen::MatrixXd B;
    Eigen::VectorXd b;
    Eigen::VectorXd prior;
    Eigen::VectorXd scale;

    LinearMap
    map() const
    {
      return {[this](const Eigen::VectorXd &x) {
                return Eigen::VectorXd(B * x);
              },
              [this](const Eigen::VectorXd &y) {
                return Eigen::VectorXd(B.transpose() * y);
              }};
    }

    /** All squares as those of one system's rows. */
    Eigen::MatrixXd
    rows() const
    {
      Eigen::MatrixXd A(B.rows() + n, n);
      A << B, Eigen::MatrixXd(scale.cwiseInverse().asDiagonal());
      return A;
    }

    Eigen::VectorXd
    right_side() const
    {
      Eigen::VectorXd d(B.rows() + n);
      d << b, prior.cwiseQuotient(scale);
      return d;
    }
  };

  /** Variables of very different units, singular values that fall fast. */
  Problem
  random_problem(const int n_rows, const double prior_weight, Random &random)
  {
    Eigen::VectorXd units(n);
    for (double &unit : units)
      unit = std::exp(random(-8., 8.));
    Eigen::VectorXd decay(n_rows);
    for (int i = 0; i < n_rows; ++i)
      decay[i] = std::exp(-0.2 * i);
    return {decay.asDiagonal() * random.matrix(n_rows, n) *
              units.cwiseInverse().asDiagonal(),
            random.matrix(n_rows, 1),
            units.cwiseProduct(random.matrix(n, 1)),
            units / prior_weight};
  }

  const std::vector<bool> free_ones(n, false);
  const std::vector<bool> bounded(n, true);

  Eigen::VectorXd
  minimise(const Problem &problem, const std::vector<bool> &nonnegative)
  {
    return bounded_least_squares(
      problem.map(), problem.b, problem.prior, problem.scale, nonnegative);
  }

  TEST(BoundedLeastSquares, WithoutBoundsIsTheDenseSolution)
  {
    Random random(701);
    for (const int n_rows : {1, 20, 80})
      for (const double weight : {1., 0.01})
        {
          const Problem problem   = random_problem(n_rows, weight, random);
          const Eigen::VectorXd x = minimise(problem, free_ones);
          const Eigen::MatrixXd A = problem.rows() * problem.scale.asDiagonal();
          const Eigen::VectorXd expected =
            A.colPivHouseholderQr().solve(problem.right_side());
          EXPECT_LT((x.cwiseQuotient(problem.scale) - expected).norm(),
                    1e-6 * expected.norm());
        }
  }

  TEST(BoundedLeastSquares, IsThatOfTheActiveSetMethod)
  {
    Random random(702);
    for (const int n_rows : {1, 20, 80})
      for (const double weight : {1., 0.01})
        for (int repetition = 0; repetition < 5; ++repetition)
          {
            const Problem problem   = random_problem(n_rows, weight, random);
            const Eigen::VectorXd x = minimise(problem, bounded);
            const Eigen::MatrixXd A =
              problem.rows() * problem.scale.asDiagonal();
            const Eigen::VectorXd expected =
              nonnegative_least_squares(A.transpose() * A,
                                        A.transpose() * problem.right_side(),
                                        n);
            EXPECT_LT((x.cwiseQuotient(problem.scale) - expected).norm(),
                      1e-6 * expected.norm());
            EXPECT_GE(x.minCoeff(), 0.);
            EXPECT_GT((x.array() == 0.).count(), 2);
          }
  }

  /** Free ones may be negative, of either kind there are some. */
  TEST(BoundedLeastSquares, MeetsTheConditionsOfOptimality)
  {
    Random random(703);
    std::vector<bool> mixed(n, true);
    for (int s = 0; s < n; s += 3)
      mixed[s] = false;
    for (int repetition = 0; repetition < 10; ++repetition)
      {
        const Problem problem   = random_problem(30, 0.1, random);
        const Eigen::VectorXd x = minimise(problem, mixed);
        const Eigen::VectorXd z = x.cwiseQuotient(problem.scale);
        const Eigen::MatrixXd A = problem.rows() * problem.scale.asDiagonal();
        const Eigen::VectorXd derivative =
          A.transpose() * (A * z - problem.right_side());
        const double rounding = 1e-7 * problem.right_side().norm();
        for (int s = 0; s < n; ++s)
          EXPECT_LT(std::abs(mixed[s] ? std::min(z[s], derivative[s])
                                      : derivative[s]),
                    rounding);
        EXPECT_LT(x.minCoeff(), 0.);
      }
  }

  TEST(BoundedLeastSquares, WithoutEquationsIsThePriorRaisedToItsBounds)
  {
    Random random(704);
    Problem problem = random_problem(5, 1., random);
    problem.B.setZero();
    problem.b.setZero();
    EXPECT_EQ(minimise(problem, free_ones), problem.prior);
    EXPECT_EQ(minimise(problem, bounded), problem.prior.cwiseMax(0.));
  }

  TEST(BoundedLeastSquares, RefusesWhatIsNotANumber)
  {
    Random random(705);
    Problem problem = random_problem(5, 1., random);
    problem.B(2, 3) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(minimise(problem, bounded), RunError);
  }
} // namespace
