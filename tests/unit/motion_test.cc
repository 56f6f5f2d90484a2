// The highest frequency against a chain's formula and dense eigenvalues, and
// the largest stable step against steps that are taken.

#include <springfit/motion/largest_mode.h>
#include <springfit/motion/stable_step.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  StiffnessProduct
  product_at_rest(const SpringNetwork &network)
  {
    return [&network](const Eigen::MatrixXd &u, Eigen::MatrixXd &product) {
      product.setZero();
      add_tangent_product(network.families, network.nodes, u, product);
    };
  }

  LargestMode
  largest_mode_of(const SpringNetwork &network,
                  const std::vector<bool> &held,
                  const double tolerance = 1e-3)
  {
    std::vector<bool> unknowns;
    for (const bool is_held : held)
      unknowns.insert(unknowns.end(), network.nodes.rows(), is_held);
    return largest_mode(network.nodes.rows(),
                        product_at_rest(network),
                        Eigen::Map<const Eigen::VectorXd>(network.mass.data(),
                                                          network.mass.size()),
                        unknowns,
                        tolerance);
  }

  /** @p n masses m between two held ends, springs k between neighbours. */
  SpringNetwork
  chain(const unsigned int n, const double k, const double m)
  {
    SpringNetwork network;
    network.nodes = Eigen::MatrixXd::Zero(3, n + 2);
    std::vector<NodePair> pairs;
    for (unsigned int v = 0; v < n + 2; ++v)
      {
        network.nodes(0, v) = 0.1 * v;
        if (v > 0)
          pairs.push_back({v - 1, v});
      }
    network.mass.assign(n + 2, m);
    network.families.push_back(
      lengths_at_rest(network.nodes,
                      pairs,
                      Eigen::VectorXd::Constant(n + 1, k),
                      SpringLaw::quadratic));
    return network;
  }

  /** A random cell of springs with random masses, and a volume if it bears one.
   */
  SpringNetwork
  random_network(const CellKind kind, Random &random)
  {
    SpringNetwork network;
    network.nodes    = oracle::random_cell(kind, random);
    const auto pairs = node_pairs(kind);
    Eigen::VectorXd k(pairs.size());
    for (double &value : k)
      value = random(0.5, 2.);
    network.families.push_back(
      lengths_at_rest(network.nodes, pairs, k, SpringLaw::quadratic));
    network.families.push_back(volume_at_rest(network.nodes, kind, 3.));
    for (Eigen::Index v = 0; v < network.nodes.cols(); ++v)
      network.mass.push_back(random(0.5, 2.));
    return network;
  }

  /** How much a motion grows in @p n steps of symplectic Euler at rest. */
  double
  growth(const SpringNetwork &network,
         const RayleighDamping &damping,
         const double step,
         const unsigned int n)
  {
    const Eigen::VectorXd inverse =
      Eigen::Map<const Eigen::VectorXd>(network.mass.data(),
                                        network.mass.size())
        .cwiseInverse();
    const Eigen::SparseMatrix<double> K =
      tangent(network.families, network.nodes);
    Eigen::VectorXd m(K.rows());
    for (Eigen::Index i = 0; i < m.size(); ++i)
      m[i] = inverse[i / network.nodes.rows()];
    Random random(5);
    Eigen::VectorXd u(K.rows()), v = Eigen::VectorXd::Zero(K.rows());
    for (double &x : u)
      x = random(-1., 1.);
    double largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const Eigen::VectorXd resisting =
          K * (u + damping.stiffness_factor * v);
        v -= step * (m.cwiseProduct(resisting) + damping.mass_factor * v);
        u += step * v;
        largest = std::max(largest, u.norm());
      }
    return largest;
  }
} // namespace

TEST(LargestMode, of_a_chain)
{
  for (const unsigned int n : {1u, 2u, 7u, 40u})
    {
      const auto network = chain(n, 50., 0.2);
      std::vector<bool> held(n + 2, false);
      held.front() = held.back() = true;
      const LargestMode mode     = largest_mode_of(network, held, 1e-9);
      const double sine          = std::sin(0.5 * M_PI * n / (n + 1.));
      EXPECT_NEAR(mode.square,
                  4. * 50. / 0.2 * sine * sine,
                  1e-5 * mode.square);
      EXPECT_EQ(mode.shape.col(0).norm(), 0.);
      EXPECT_NEAR(mode.shape.norm(), 1., 1e-12);
      EXPECT_LE(spring_bound_of_step(network, held),
                stable_step({}, std::sqrt(mode.square)));
    }
  // It holds where springs of k < 0 hide others from the sum.
  auto mixed = chain(9, 50., 0.2);
  auto &k    = mixed.families[0].members.columns[0];
  for (std::size_t m = 0; m < k.size(); m += 2)
    k[m] = -45.;
  const std::vector<bool> nothing(11, false);
  EXPECT_LE(spring_bound_of_step(mixed, nothing),
            stable_step({}, std::sqrt(largest_mode_of(mixed, nothing).square)));
  // The bound is that of a long chain.
  const auto network = chain(400, 50., 0.2);
  const std::vector<bool> free(402, false);
  EXPECT_NEAR(spring_bound_of_step(network, free),
              stable_step({}, std::sqrt(largest_mode_of(network, free).square)),
              1e-3 * spring_bound_of_step(network, free));
}

TEST(LargestMode, of_cells_with_volumes_is_the_dense_eigenvalue)
{
  Random random(3);
  for (const CellKind kind : oracle::all_kinds)
    for (unsigned int i = 0; i < 20; ++i)
      {
        const auto network     = random_network(kind, random);
        const unsigned int dim = network.nodes.rows();
        Eigen::MatrixXd K      = tangent(network.families, network.nodes);
        for (Eigen::Index a = 0; a < K.rows(); ++a)
          for (Eigen::Index b = 0; b < K.cols(); ++b)
            K(a, b) /= std::sqrt(network.mass[a / dim] * network.mass[b / dim]);
        const double exact =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues().tail(
            1)[0];
        const auto mode =
          largest_mode_of(network,
                          std::vector<bool>(network.nodes.cols(), false),
                          1e-6);
        EXPECT_NEAR(mode.square, exact, 1e-5 * exact);
        EXPECT_LE(mode.lowest, exact * (1. + 1e-12));
      }
}

TEST(LargestMode, of_what_does_not_move_is_zero)
{
  const auto network = chain(3, 50., 0.2);
  EXPECT_EQ(largest_mode_of(network, std::vector<bool>(5, true)).square, 0.);
}

// 2 % apart on either side, as every motion of a linear body is a sum of those
// of its frequencies.
TEST(StableStep, is_where_motion_begins_to_grow)
{
  Random random(7);
  for (const CellKind kind : oracle::all_kinds)
    for (const RayleighDamping &damping : {RayleighDamping{},
                                           RayleighDamping{0.5, 0.},
                                           RayleighDamping{0., 0.3},
                                           RayleighDamping{0.4, 0.1}})
      {
        const auto network = random_network(kind, random);
        const auto mode =
          largest_mode_of(network,
                          std::vector<bool>(network.nodes.cols(), false),
                          1e-6);
        const double step = stable_step(damping, std::sqrt(mode.square));
        EXPECT_LT(growth(network, damping, 0.98 * step, 2000), 1e3);
        EXPECT_GT(growth(network, damping, 1.02 * step, 2000), 1e6);
      }
}

TEST(StableStep, of_extremes)
{
  EXPECT_TRUE(std::isinf(stable_step({}, 0.)));
  EXPECT_DOUBLE_EQ(stable_step({}, 4.), 0.5);
  EXPECT_DOUBLE_EQ(stable_step({3., 0.}, 0.), 2. / 3.);
  EXPECT_DOUBLE_EQ(damping_ratio({3., 0.5}, 2.), 0.5 * (1.5 + 1.));
}
