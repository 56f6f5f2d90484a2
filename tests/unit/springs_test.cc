#include <springfit/core/error.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/generalised_spring.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/length.h>
#include <springfit/springs/negative.h>
#include <springfit/springs/rigid_modes.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "cells.h"

using namespace springfit;
using springfit::oracle::all_kinds;
using springfit::oracle::Random;

namespace
{
  TEST(CellTopology, EveryPairOnce)
  {
    const std::map<CellKind, std::size_t> n_springs = {
      {CellKind::triangle, 3},
      {CellKind::quadrilateral, 6},
      {CellKind::tetrahedron, 6},
      {CellKind::hexahedron, 28}};
    for (const CellKind kind : all_kinds)
      {
        const auto &pairs = node_pairs(kind);
        EXPECT_EQ(pairs.size(), n_springs.at(kind));
        EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
        EXPECT_EQ(std::set<NodePair>(pairs.begin(), pairs.end()).size(),
                  pairs.size());
        for (const auto &[i, j] : pairs)
          EXPECT_TRUE(i < j && int(j) < n_vertices(kind));
      }
  }

  TEST(CellTopology, SymmetriesKeepTheRegularCell)
  {
    const std::map<CellKind, std::size_t> n_symmetries = {
      {CellKind::triangle, 6},
      {CellKind::quadrilateral, 8},
      {CellKind::tetrahedron, 24},
      {CellKind::hexahedron, 48}};
    for (const CellKind kind : all_kinds)
      {
        const auto &group = symmetries(kind);
        EXPECT_EQ(group.size(), n_symmetries.at(kind));
        EXPECT_EQ(std::set<std::vector<unsigned int>>(group.begin(),
                                                      group.end())
                    .size(),
                  group.size());
        const Eigen::MatrixXd x = oracle::regular_cell(kind);
        for (const auto &p : group)
          for (const auto &[i, j] : node_pairs(kind))
            EXPECT_NEAR((x.col(j) - x.col(i)).norm(),
                        (x.col(p[j]) - x.col(p[i])).norm(),
                        1e-14);
      }
  }

  TEST(CellTopology, SymmetriesRenumberTheStiffnessOfAnyCell)
  {
    Random random(1);
    for (const CellKind kind : all_kinds)
      {
        const int dim           = dimension(kind);
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const Eigen::MatrixXd D = oracle::usual_elasticity(kind, 0.3);
        const Eigen::MatrixXd R = oracle::stiffness(x, kind, D);
        for (const auto &p : symmetries(kind))
          {
            Eigen::MatrixXd renumbered(x.rows(), x.cols());
            for (int v = 0; v < x.cols(); ++v)
              renumbered.col(p[v]) = x.col(v);
            const Eigen::MatrixXd S = oracle::stiffness(renumbered, kind, D);
            for (int v = 0; v < x.cols(); ++v)
              for (int w = 0; w < x.cols(); ++w)
                EXPECT_LT((S.block(dim * p[v], dim * p[w], dim, dim) -
                           R.block(dim * v, dim * w, dim, dim))
                            .norm(),
                          1e-13);
          }
      }
  }


  // Of functions of (x_i, x_j), by central differences.

  template <int dim>
  using Pair = Vector<2 * dim>;

  template <int dim>
  Vector<dim>
  difference(const Pair<dim> &x)
  {
    return x.template tail<dim>() - x.template head<dim>();
  }

  template <typename F, int n>
  auto
  derivative(const F &f, const Eigen::Matrix<double, n, 1> &x, const int i)
  {
    constexpr double h                     = 1e-5;
    const Eigen::Matrix<double, n, 1> step = h * Vector<n>::Unit(i);
    return ((f(x + step) - f(x - step)) / (2. * h));
  }

  template <int dim>
  void
  check_length_by_differences()
  {
    Random random(dim);
    const double k = 3., rest = 0.7;
    const Pair<dim> x = random.matrix(2 * dim, 1);
    const auto q      = [](const Pair<dim> &y) {
      return length<dim>(difference<dim>(y));
    };
    const auto gradient = [](const Pair<dim> &y) -> Pair<dim> {
      return length_gradient<dim>(difference<dim>(y));
    };
    const auto energy = [&](const Pair<dim> &y) {
      return spring_energy(k, q(y), rest);
    };
    const auto force = [&](const Pair<dim> &y) -> Pair<dim> {
      return spring_force(k, q(y), rest, gradient(y));
    };
    const Tensor<2 *dim> hessian = length_hessian<dim>(difference<dim>(x));
    const Tensor<2 *dim> tangent =
      spring_tangent(k, q(x), rest, gradient(x), hessian);

    for (int i = 0; i < 2 * dim; ++i)
      {
        EXPECT_NEAR(derivative(q, x, i), gradient(x)[i], 1e-9);
        EXPECT_NEAR(derivative(energy, x, i), -force(x)[i], 1e-9);
        for (int j = 0; j < 2 * dim; ++j)
          {
            const auto g_j = [&](const Pair<dim> &y) { return gradient(y)[j]; };
            const auto f_j = [&](const Pair<dim> &y) { return force(y)[j]; };
            EXPECT_NEAR(derivative(g_j, x, i), hessian(j, i), 1e-9);
            EXPECT_NEAR(derivative(f_j, x, i), -tangent(j, i), 1e-8);
          }
      }

    // The special forms of a length are the general ones.
    const Vector<dim> d = difference<dim>(x);
    EXPECT_LT(
      (length_force<dim>(k, rest, d) - force(x).template head<dim>()).norm(),
      1e-14);
    const Tensor<dim> block = length_tangent_block<dim>(k, rest, d);
    EXPECT_LT((block - tangent.template topLeftCorner<dim, dim>()).norm(),
              1e-14);
    EXPECT_LT((block + tangent.template topRightCorner<dim, dim>()).norm(),
              1e-14);
  }

  TEST(Length, DerivativesAgreeWithDifferences)
  {
    check_length_by_differences<2>();
    check_length_by_differences<3>();
  }

  TEST(Length, AStretchedSpringPullsItsNodesTogether)
  {
    const Vector<2> d(3., 4.);
    EXPECT_DOUBLE_EQ(length<2>(d), 5.);
    // k (|d| - L0) n = 10 * 1 * (0.6, 0.8) on node i, towards j
    EXPECT_LT((length_force<2>(10., 4., d) - Vector<2>(6., 8.)).norm(), 1e-14);
    EXPECT_DOUBLE_EQ(spring_energy(10., 5., 4.), 5.);
  }

  TEST(Gradients, TangentAtRestIsTheSumOfTheSprings)
  {
    Random random(3);
    for (const CellKind kind : all_kinds)
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const int dim           = x.rows();
        const Eigen::MatrixXd B = length_gradients(x, node_pairs(kind));
        const double h          = 1e-6;
        ASSERT_EQ(B.rows(), x.size());
        ASSERT_EQ(B.cols(), int(node_pairs(kind).size()));
        for (int s = 0; s < B.cols(); ++s)
          for (int v = 0; v < x.cols(); ++v)
            for (int d = 0; d < dim; ++d)
              {
                const auto [i, j]    = node_pairs(kind)[s];
                Eigen::MatrixXd plus = x, minus = x;
                plus(d, v) += h;
                minus(d, v) -= h;
                const double slope = ((plus.col(j) - plus.col(i)).norm() -
                                      (minus.col(j) - minus.col(i)).norm()) /
                                     (2. * h);
                EXPECT_NEAR(B(dim * v + d, s), slope, 1e-8);
              }
      }
  }

  TEST(Gradients, CoincidentNodesAreRefused)
  {
    Eigen::MatrixXd x = oracle::regular_cell(CellKind::triangle);
    x.col(1)          = x.col(0);
    EXPECT_THROW(length_gradients(x, node_pairs(CellKind::triangle)), RunError);
  }


  TEST(RigidModes, BasesAreOrthonormalAndComplementary)
  {
    const std::map<CellKind, int> n_deformations = {{CellKind::triangle, 3},
                                                    {CellKind::quadrilateral,
                                                     5},
                                                    {CellKind::tetrahedron, 6},
                                                    {CellKind::hexahedron, 18}};
    Random random(4);
    for (const CellKind kind : all_kinds)
      {
        // Far from the origin and small, as in a mesh in metres.
        const Eigen::MatrixXd x =
          (0.01 * oracle::random_cell(kind, random)).array() + 3.;
        const Eigen::MatrixXd rigid = rigid_body_modes(x);
        const Eigen::MatrixXd rest  = deformation_basis(x);
        EXPECT_EQ(rest.cols(), n_deformations.at(kind));
        Eigen::MatrixXd both(x.size(), x.size());
        both << rigid, rest;
        EXPECT_TRUE((both.transpose() * both).isIdentity(1e-12));
      }
  }

  TEST(RigidModes, NeitherElementNorSpringsResistThem)
  {
    Random random(5);
    for (const CellKind kind : all_kinds)
      {
        const FitProblem problem    = oracle::random_problem(kind, random);
        const Eigen::MatrixXd rigid = rigid_body_modes(problem.points);
        EXPECT_LT((problem.stiffness * rigid).norm(), 1e-12);
        EXPECT_LT((problem.gradients.transpose() * rigid).norm(), 1e-12);
        // ... but everything else, so no mode is missing.
        const Eigen::MatrixXd Q = deformation_basis(problem.points);
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                    Q.transpose() * problem.stiffness * Q)
                    .eigenvalues()[0],
                  1e-4);
      }
  }


  TEST(Negative, RoundingErrorsDoNotCount)
  {
    EXPECT_EQ(n_negative(Eigen::Vector4d(1., -1e-14, -1e-3, 0.)), 1u);
    EXPECT_EQ(n_negative(Eigen::VectorXd()), 0u);
  }
} // namespace
