// Factors in blocks against dense ones of the same matrices.

#include <springfit/motion/block_factors.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  /** Nodes on a ring, of which each also knows one across it. */
  NodePattern
  ring(const unsigned int n)
  {
    NodePattern pattern(n);
    for (unsigned int v = 0; v < n; ++v)
      for (const unsigned int w : {(v + 1) % n, (5 * v + 2) % n})
        {
          const unsigned int pair[] = {v, w};
          pattern.add_clique(pair, 2);
        }
    return pattern;
  }

  /** Of random symmetric blocks, with @p diagonal added; alone: uncoupled. */
  template <int dim>
  TangentMatrix
  random_matrix(const NodePattern &pattern,
                const std::vector<bool> &alone,
                const double diagonal)
  {
    using Block = Eigen::Matrix<double, dim, dim>;
    Random random(dim);
    TangentMatrix matrix(dim, pattern);
    const auto neighbours = pattern.neighbours();
    for (unsigned int v = 0; v < neighbours.size(); ++v)
      for (const unsigned int w : neighbours[v])
        {
          const Block block = random.matrix(dim, dim);
          if (w == v)
            matrix.add(v,
                       v,
                       Block(block + block.transpose() +
                             diagonal * Block::Identity()));
          else if (w > v && !alone[v] && !alone[w])
            {
              matrix.add(v, w, block);
              matrix.add(w, v, Block(block.transpose()));
            }
        }
    return matrix;
  }

  template <int dim, typename Number>
  void
  expect_solutions(const double diagonal, const bool is_positive)
  {
    const NodePattern pattern = ring(23);
    std::vector<bool> alone(23);
    alone[3] = alone[4] = alone[22] = true;
    const auto factors = make_block_factors<Number>(dim, pattern, alone);
    const auto matrix  = random_matrix<dim>(pattern, alone, diagonal);
    const Eigen::MatrixXd A(matrix.matrix());
    // Twice, because what is left of the first must not count.
    for (unsigned int i = 0; i < 2; ++i)
      {
        factors->factorise(matrix.matrix());
        ASSERT_TRUE(factors->exist());
        EXPECT_EQ(factors->are_positive(), is_positive);
        const Eigen::MatrixXd b = Random(i + 1).matrix(dim, 23);
        Eigen::MatrixXd x       = b;
        factors->solve(x);
        const Eigen::VectorXd exact = A.partialPivLu().solve(b.reshaped());
        EXPECT_LT((x.reshaped() - exact).norm(),
                  1e4 * std::numeric_limits<Number>::epsilon() * exact.norm());
      }
  }
} // namespace

TEST(BlockFactors, solve_what_is_positive_definite)
{
  expect_solutions<2, double>(10., true);
  expect_solutions<3, double>(10., true);
  expect_solutions<2, float>(10., true);
  expect_solutions<3, float>(10., true);
}

TEST(BlockFactors, solve_what_is_not)
{
  expect_solutions<2, double>(-10., false);
  expect_solutions<3, double>(-10., false);
  expect_solutions<2, double>(0., false);
  expect_solutions<3, double>(0., false);
}

TEST(BlockFactors, say_that_there_are_none)
{
  const NodePattern pattern = ring(7);
  const std::vector<bool> alone(7);
  const auto factors = make_block_factors<double>(3, pattern, alone);
  EXPECT_FALSE(factors->exist());
  TangentMatrix matrix(3, pattern); // zero
  factors->factorise(matrix.matrix());
  EXPECT_FALSE(factors->exist());
  EXPECT_FALSE(factors->are_positive());
  // A failure leaves nothing behind.
  matrix = random_matrix<3>(pattern, alone, 10.);
  factors->factorise(matrix.matrix());
  EXPECT_TRUE(factors->are_positive());
  const Eigen::MatrixXd b = Random(1).matrix(3, 7);
  Eigen::MatrixXd x       = b;
  factors->solve(x);
  EXPECT_LT((matrix.matrix() * x.reshaped() - b.reshaped()).norm(), 1e-12);
}
