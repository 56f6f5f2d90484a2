// Several families as one body.

#include <springfit/springs/cell_topology.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/rigid_modes.h>
#include <springfit/springs/volume.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "cells.h"
#include "derivative.h"
#include "families.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  /** A cell with springs of every kind of enrichment. */
  SpringNetwork
  full_network(const CellKind kind, const SpringLaw law, Random &random)
  {
    const Eigen::MatrixXd x = oracle::random_cell(kind, random);
    const Nodes vertices    = first_nodes(x.cols());
    const auto &pairs       = node_pairs(kind);
    const auto &triples     = cell_angles(kind);
    NetworkBuilder builder(x);
    builder.add(lengths_at_rest(x, pairs, random.matrix(pairs.size(), 1), law),
                vertices);
    builder.add(couplings_at_rest(x, pairs, {{0, 1, 0.7}, {1, 2, -0.4}}, law),
                vertices);
    builder.add(angles_at_rest(x, triples, random.matrix(triples.size(), 1)),
                vertices);
    builder.add(volume_at_rest(x, kind, 2.), vertices);
    return builder.build();
  }

  TEST(Network, IsConsistentAndHasTheGradientsTangentAtRest)
  {
    Random random(52);
    for (const CellKind cell : oracle::all_kinds)
      for (const SpringLaw law : laws)
        {
          const auto network = full_network(cell, law, random);
          ASSERT_EQ(network.families.size(), 4u);
          const Family &springs = network.families[0];
          const Family &coupled = network.families[1];
          const Family &angular = network.families[2];
          EXPECT_EQ(springs.size(), node_pairs(cell).size());
          EXPECT_EQ(coupled.size(), 2u);
          EXPECT_EQ(angular.size(), cell_angles(cell).size());
          EXPECT_EQ(network.families[3].size(), 1u);

          const auto U = [&](const Eigen::MatrixXd &y) {
            return scalar(energy(network.families, y));
          };
          const auto gradient =
            [&](const Eigen::MatrixXd &y) -> Eigen::VectorXd {
            Eigen::MatrixXd forces = zero_like(y);
            add_forces(network.families, y, forces);
            return -forces.reshaped();
          };
          const Eigen::MatrixXd &rest = network.nodes;
          const Eigen::MatrixXd x =
            rest + 0.1 * random.matrix(rest.rows(), rest.cols());
          EXPECT_LT((derivative(U, x).transpose() - gradient(x)).norm(), 1e-7);
          EXPECT_LT((derivative(gradient, x) -
                     Eigen::MatrixXd(tangent(network.families, x)))
                      .norm(),
                    1e-6);
          const Eigen::MatrixXd u = random.matrix(x.rows(), x.cols());
          Eigen::MatrixXd product = zero_like(x);
          add_tangent_product(network.families, x, u, product);
          EXPECT_LT((product.reshaped() -
                     tangent(network.families, x) * u.reshaped())
                      .norm(),
                    1e-12);

          // At rest the tangent is that of the gradients b_s, whatever the law.
          std::vector<NodePair> pairs;
          for (std::size_t s = 0; s < springs.size(); ++s)
            pairs.push_back({{springs.nodes(s)[0], springs.nodes(s)[1]}});
          const Eigen::MatrixXd B = length_gradients(rest, pairs);
          Eigen::MatrixXd K       = Eigen::MatrixXd::Zero(x.size(), x.size());
          for (Eigen::Index s = 0; s < B.cols(); ++s)
            K +=
              springs.members.columns[0][s] * B.col(s) * B.col(s).transpose();
          for (std::size_t m = 0; m < coupled.size(); ++m)
            {
              const unsigned int *nodes = coupled.nodes(m);
              const Eigen::MatrixXd b   = length_gradients(
                rest, {{{nodes[0], nodes[1]}}, {{nodes[2], nodes[3]}}});
              K += coupled.members.columns[0][m] *
                   (b.col(0) * b.col(1).transpose() +
                    b.col(1) * b.col(0).transpose());
            }
          for (std::size_t m = 0; m < angular.size(); ++m)
            {
              const unsigned int *nodes = angular.nodes(m);
              const Eigen::VectorXd b =
                angle_gradients(rest, {{{nodes[0], nodes[1], nodes[2]}}});
              K += angular.members.columns[0][m] * b * b.transpose();
            }
          const Eigen::VectorXd b = volume_gradient(rest, cell);
          K += 2. * b * b.transpose();
          EXPECT_LT(gradient(rest).norm(), 1e-13);
          EXPECT_LT(
            (Eigen::MatrixXd(tangent(network.families, rest)) - K).norm(),
            1e-12);
        }
  }

  TEST(Network, HasNoDerivativesWhereItIsDegenerate)
  {
    const Eigen::MatrixXd rest = oracle::regular_cell(CellKind::triangle);
    const Family spring        = lengths_at_rest(rest,
                                          {{0, 1}},
                                          Eigen::VectorXd::Ones(1),
                                          SpringLaw::quadratic);
    const Family angle =
      angles_at_rest(rest, {{0, 2, 1}}, Eigen::VectorXd::Ones(1));
    const double infinity = std::numeric_limits<double>::infinity();

    Eigen::MatrixXd x = rest;
    x(1, 2)           = 0.; // the apex between the others
    EXPECT_TRUE(std::isfinite(energy_of(spring, x)));
    EXPECT_EQ(energy_of(angle, x), infinity);
    EXPECT_EQ(energy({spring, angle}, x), infinity);
    x       = rest;
    x(0, 1) = 0.; // the two ends of the base at one place
    EXPECT_EQ(energy_of(spring, x), infinity);
    EXPECT_EQ(energy_of(angle, x), infinity);
    Eigen::MatrixXd forces = zero_like(x);
    add_forces({spring, angle}, x, forces);
    EXPECT_TRUE(forces.isZero(0.));
  }


  /**
   * The P1 cell as springs and couplings: C = B^-1 R B^-T in the basis of the
   * deformations.
   */
  SpringNetwork
  fully_coupled(const Eigen::MatrixXd &x, const Eigen::MatrixXd &R)
  {
    const CellKind kind     = cell_kind(x.rows(), x.cols());
    const auto &pairs       = node_pairs(kind);
    const Eigen::MatrixXd Q = deformation_basis(x);
    const Eigen::MatrixXd inverse =
      (Q.transpose() * length_gradients(x, pairs)).inverse();
    const Eigen::MatrixXd C =
      inverse * Q.transpose() * R * Q * inverse.transpose();
    std::vector<LengthCoupling> couplings;
    for (unsigned int a = 0; a < pairs.size(); ++a)
      for (unsigned int b = a + 1; b < pairs.size(); ++b)
        couplings.push_back({a, b, C(a, b)});
    const Nodes vertices = first_nodes(x.cols());
    const SpringLaw law  = SpringLaw::biquadratic;
    NetworkBuilder builder(x);
    builder.add(lengths_at_rest(x, pairs, C.diagonal(), law), vertices);
    builder.add(couplings_at_rest(x, pairs, couplings, law), vertices);
    return builder.build();
  }

  template <int dim>
  void
  check_st_venant_kirchhoff(const CellKind kind)
  {
    Random random(53);
    const double lambda = 1.7, mu = 0.6;
    for (int sample = 0; sample < 100; ++sample)
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const double V          = std::abs(volume(x, kind));
        const auto network      = fully_coupled(
          x, oracle::stiffness(x, kind, oracle::isotropic(dim, lambda, mu)));

        // Any deformation of the cell is x -> F x + t, inside out or not.
        const Eigen::Matrix<double, dim, dim> F = 2. * random.matrix(dim, dim);
        const Eigen::VectorXd t                 = random.matrix(dim, 1);
        const Eigen::MatrixXd y                 = (F * x).colwise() + t;

        const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(dim, dim);
        const Eigen::MatrixXd E = 0.5 * (F.transpose() * F - I);
        const double expected =
          V * (0.5 * lambda * E.trace() * E.trace() + mu * E.squaredNorm());
        // Forces - V F S grad N_v with S = lambda tr(E) I + 2 mu E.
        const Eigen::MatrixXd S = lambda * E.trace() * I + 2. * mu * E;
        Eigen::MatrixXd gradients(dim, dim + 1);
        const Eigen::MatrixXd J    = x.rightCols(dim).colwise() - x.col(0);
        gradients.rightCols(dim)   = J.inverse().transpose();
        gradients.col(0)           = -gradients.rightCols(dim).rowwise().sum();
        const Eigen::MatrixXd pull = V * F * S * gradients;

        Eigen::MatrixXd forces = zero_like(y);
        add_forces(network.families, y, forces);
        EXPECT_NEAR(energy(network.families, y), expected, 1e-12 * expected);
        EXPECT_LT((forces + pull).norm(), 1e-12 * pull.norm());
      }
  }

  TEST(BiquadraticSprings, WithAllCouplingsAreStVenantKirchhoffsMaterial)
  {
    check_st_venant_kirchhoff<2>(CellKind::triangle);
    check_st_venant_kirchhoff<3>(CellKind::tetrahedron);
  }
} // namespace
