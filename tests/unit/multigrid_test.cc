// The V cycle as an operator: symmetric, positive, and an inverse so near that
// the iterations of the conjugate gradient method hardly depend on the size.

#include <springfit/motion/multigrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  /** Springs between the nodes of a grid of n^3 cells, all 28 of a cell. */
  Eigen::SparseMatrix<double>
  grid(const int n, const double mass, Random &random)
  {
    const int m      = n + 1;
    const auto index = [m](const int i, const int j, const int k) {
      return i + m * (j + m * k);
    };
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          for (int a = 0; a < 8; ++a)
            for (int b = 0; b < a; ++b)
              {
                const int v    = index(i + a % 2, j + a / 2 % 2, k + a / 4);
                const int w    = index(i + b % 2, j + b / 2 % 2, k + b / 4);
                const double s = random(0.5, 2.);
                entries.emplace_back(v, v, s);
                entries.emplace_back(w, w, s);
                entries.emplace_back(v, w, -s);
                entries.emplace_back(w, v, -s);
              }
    for (int v = 0; v < m * m * m; ++v)
      entries.emplace_back(v, v, v < m * m ? 1e3 : mass); // one side is held
    Eigen::SparseMatrix<double> matrix(m * m * m, m * m * m);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  Eigen::MatrixXd
  random_motion(const Eigen::Index n, Random &random)
  {
    Eigen::MatrixXd motion(3, n);
    for (double &x : motion.reshaped())
      x = random(-1., 1.);
    return motion;
  }

  /** Iterations to a residual of 1e-8, of all three components at once. */
  unsigned int
  n_iterations(const Eigen::SparseMatrix<double> &A,
               Multigrid &inverse,
               const Eigen::MatrixXd &b)
  {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(3, b.cols()), r = b, z;
    inverse.apply(r, z);
    Eigen::MatrixXd p = z;
    double rz         = r.cwiseProduct(z).sum();
    unsigned int n    = 0;
    for (; r.norm() > 1e-8 * b.norm() && n < 200; ++n)
      {
        const Eigen::MatrixXd q = p * A;
        const double alpha      = rz / p.cwiseProduct(q).sum();
        x += alpha * p;
        r -= alpha * q;
        inverse.apply(r, z);
        const double next = r.cwiseProduct(z).sum();
        p                 = z + next / rz * p;
        rz                = next;
      }
    EXPECT_LT((x * A - b).norm(), 1e-7 * b.norm());
    return n;
  }
} // namespace

TEST(Multigrid, is_symmetric_and_positive)
{
  Random random(1);
  const auto A = grid(12, 1e-3, random);
  Multigrid inverse(A);
  EXPECT_GT(inverse.sizes().size(), 1u);
  EXPECT_LT(inverse.operator_complexity(), 2.2);
  for (unsigned int i = 0; i < 10; ++i)
    {
      const auto a = random_motion(A.rows(), random),
                 b = random_motion(A.rows(), random);
      Eigen::MatrixXd on_a, on_b;
      inverse.apply(a, on_a);
      inverse.apply(b, on_b);
      EXPECT_NEAR(a.cwiseProduct(on_b).sum(),
                  b.cwiseProduct(on_a).sum(),
                  1e-5 * a.norm() * on_b.norm());
      EXPECT_GT(a.cwiseProduct(on_a).sum(), 0.);
    }
}

TEST(Multigrid, converges_alike_on_all_sizes)
{
  for (const double mass : {0., 1e-2, 1., 100.})
    for (const int n : {5, 10, 20})
      {
        Random random(n);
        const auto A = grid(n, mass, random);
        Multigrid inverse(A);
        EXPECT_LE(n_iterations(A, inverse, random_motion(A.rows(), random)),
                  22u)
          << n << ' ' << mass;
      }
}

// Each of 26 equal neighbours is weak beside the diagonal.
TEST(Multigrid, joins_nodes_of_many_equal_neighbours)
{
  Random random(3);
  auto A = grid(10, 0.1, random);
  for (int column = 0; column < A.outerSize(); ++column)
    {
      double n_neighbours = -1.;
      for (decltype(A)::InnerIterator entry(A, column); entry; ++entry)
        n_neighbours += 1.;
      for (decltype(A)::InnerIterator entry(A, column); entry; ++entry)
        entry.valueRef() =
          entry.row() == entry.col() ? n_neighbours + 0.1 : -1.;
    }
  Multigrid inverse(A);
  ASSERT_GT(inverse.sizes().size(), 1u);
  EXPECT_LT(inverse.sizes()[1], A.rows() / 8);
  EXPECT_LE(n_iterations(A, inverse, random_motion(A.rows(), random)), 22u);
}

TEST(Multigrid, of_a_diagonal_is_exact)
{
  Eigen::SparseMatrix<double> A(1000, 1000);
  for (int i = 0; i < 1000; ++i)
    A.insert(i, i) = 1. + i;
  Multigrid inverse(A);
  Eigen::MatrixXd result;
  inverse.apply(Eigen::MatrixXd::Ones(2, 1000), result);
  for (int i = 0; i < 1000; ++i)
    EXPECT_NEAR(result(1, i) * (1. + i), 1., 1e-5);
}
