// The energy, forces and tangent of a network's terms.

#include <springfit/springs/cell_topology.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/network.h>
#include <springfit/springs/network_terms.h>
#include <springfit/springs/rigid_modes.h>
#include <springfit/springs/volume.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "cells.h"
#include "derivative.h"

using namespace springfit;
using springfit::oracle::derivative;
using springfit::oracle::Random;
using springfit::oracle::scalar;

namespace
{
  constexpr SpringLaw laws[] = {SpringLaw::quadratic, SpringLaw::biquadratic};

  /** The sum of a network's terms. */
  struct State
  {
    double energy = 0.;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
  };

  template <int dim>
  State
  evaluate(const SpringNetwork &network, const Eigen::MatrixXd &u)
  {
    State state{0.,
                Eigen::VectorXd::Zero(u.size()),
                Eigen::MatrixXd::Zero(u.size(), u.size())};
    for (unsigned int t = 0; t < n_terms(network); ++t)
      {
        const auto term = evaluate_term<dim>(network, t, u);
        EXPECT_TRUE(term);
        EXPECT_EQ(term->nodes[0], first_node(network, t));
        state.energy += term->energy;
        for (std::size_t a = 0; a < term->nodes.size(); ++a)
          {
            state.gradient.segment<dim>(dim * term->nodes[a]) +=
              term->gradient.template segment<dim>(dim * a);
            for (std::size_t b = 0; b < term->nodes.size(); ++b)
              state.hessian.block<dim, dim>(dim * term->nodes[a],
                                            dim * term->nodes[b]) +=
                term->hessian.template block<dim, dim>(dim * a, dim * b);
          }
      }
    return state;
  }

  std::vector<unsigned int>
  vertices_of(const CellKind kind)
  {
    std::vector<unsigned int> vertices(n_vertices(kind));
    std::iota(vertices.begin(), vertices.end(), 0);
    return vertices;
  }

  /** A cell with terms of every kind. */
  SpringNetwork
  full_network(const CellKind kind, const SpringLaw law, Random &random)
  {
    const Eigen::MatrixXd x = oracle::random_cell(kind, random);
    const auto vertices     = vertices_of(kind);
    const auto &pairs       = node_pairs(kind);
    const auto &triples     = cell_angles(kind);
    NetworkBuilder builder(x);
    builder.add_springs(vertices, pairs, random.matrix(pairs.size(), 1));
    builder.add_couplings(vertices, pairs, {{0, 1, 0.7}, {1, 2, -0.4}});
    builder.add_angles(vertices, triples, random.matrix(triples.size(), 1));
    builder.add_volume(vertices, 2., volume(x, kind));
    SpringNetwork network = builder.build();
    network.law           = law;
    return network;
  }

  template <int dim>
  void
  check_terms(const SpringNetwork &network, Random &random)
  {
    EXPECT_EQ(n_terms(network),
              network.stiffness.size() + 2 + network.angles.size() + 1);
    const auto energy = [&](const Eigen::MatrixXd &u) {
      return scalar(evaluate<dim>(network, u).energy);
    };
    const auto gradient = [&](const Eigen::MatrixXd &u) {
      return evaluate<dim>(network, u).gradient;
    };
    const Eigen::MatrixXd u = 0.1 * random.matrix(dim, network.nodes.cols());
    const State state       = evaluate<dim>(network, u);
    EXPECT_LT((derivative(energy, u).transpose() - state.gradient).norm(),
              1e-7);
    Eigen::MatrixXd gradient_alone = Eigen::MatrixXd::Zero(dim, u.cols());
    for (unsigned int t = 0; t < n_terms(network); ++t)
      EXPECT_TRUE(add_term_gradient<dim>(network, t, u, gradient_alone));
    EXPECT_LT(
      (derivative(energy, u) - gradient_alone.reshaped().transpose()).norm(),
      1e-7);
    EXPECT_LT((derivative(gradient, u) - state.hessian).norm(), 1e-6);

    // At rest the tangent is that of the gradients b_s, whatever the law.
    const State rest = evaluate<dim>(network, 0. * u);
    std::vector<NodePair> springs;
    for (std::size_t s = 0; s < network.i.size(); ++s)
      springs.push_back({{network.i[s], network.j[s]}});
    const Eigen::MatrixXd B = length_gradients(network.nodes, springs);
    Eigen::MatrixXd K       = Eigen::MatrixXd::Zero(u.size(), u.size());
    for (Eigen::Index s = 0; s < B.cols(); ++s)
      K += network.stiffness[s] * B.col(s) * B.col(s).transpose();
    for (const auto &[a, b, k] : network.couplings)
      K +=
        k * (B.col(a) * B.col(b).transpose() + B.col(b) * B.col(a).transpose());
    for (const auto &[nodes, k, theta] : network.angles)
      {
        const Eigen::VectorXd b = angle_gradients(network.nodes, {nodes});
        K += k * b * b.transpose();
      }
    const Eigen::VectorXd b =
      volume_gradient(network.nodes, cell_kind(dim, network.nodes.cols()));
    K += 2. * b * b.transpose();
    EXPECT_LT(rest.gradient.norm(), 1e-13);
    EXPECT_LT((rest.hessian - K).norm(), 1e-12);
  }

  TEST(NetworkTerms, AreConsistentAndHaveTheGradientsTangentAtRest)
  {
    Random random(52);
    for (const CellKind kind : oracle::all_kinds)
      for (const SpringLaw law : laws)
        {
          const auto network = full_network(kind, law, random);
          if (dimension(kind) == 2)
            check_terms<2>(network, random);
          else
            check_terms<3>(network, random);
        }
  }

  TEST(NetworkTerms, HaveNoDerivativesWhereTheyAreDegenerate)
  {
    const Eigen::MatrixXd x = oracle::regular_cell(CellKind::triangle);
    NetworkBuilder builder(x);
    builder.add_springs({0, 1, 2}, {{{0, 1}}}, Eigen::VectorXd::Ones(1));
    builder.add_angles({0, 1, 2}, {{0, 2, 1}}, Eigen::VectorXd::Ones(1));
    const auto network = builder.build();

    Eigen::MatrixXd u = Eigen::MatrixXd::Zero(2, 3);
    u(1, 2)           = -x(1, 2); // the apex between the others
    EXPECT_TRUE(evaluate_term<2>(network, 0, u));
    EXPECT_FALSE(evaluate_term<2>(network, 1, u));
    u(1, 2) = 0.;
    u(0, 1) = -1.; // the two ends of the base at one place
    EXPECT_FALSE(evaluate_term<2>(network, 0, u));
    EXPECT_FALSE(evaluate_term<2>(network, 1, u));
    Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(2, 3);
    EXPECT_FALSE(add_term_gradient<2>(network, 0, u, gradient));
    EXPECT_FALSE(add_term_gradient<2>(network, 1, u, gradient));
    EXPECT_TRUE(gradient.isZero(0.));
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
    NetworkBuilder builder(x);
    builder.add_springs(vertices_of(kind), pairs, C.diagonal());
    builder.add_couplings(vertices_of(kind), pairs, couplings);
    SpringNetwork network = builder.build();
    network.law           = SpringLaw::biquadratic;
    return network;
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
        const Tensor<dim> F     = 2. * random.matrix(dim, dim);
        const Eigen::VectorXd t = random.matrix(dim, 1);
        const Eigen::MatrixXd u = ((F * x).colwise() + t) - x;

        const Tensor<dim> E =
          0.5 * (F.transpose() * F - Tensor<dim>::Identity());
        const double energy =
          V * (0.5 * lambda * E.trace() * E.trace() + mu * E.squaredNorm());
        // Forces V F S grad N_v with S = lambda tr(E) I + 2 mu E.
        const Tensor<dim> S =
          lambda * E.trace() * Tensor<dim>::Identity() + 2. * mu * E;
        Eigen::MatrixXd gradients(dim, dim + 1);
        const Eigen::MatrixXd J  = x.rightCols(dim).colwise() - x.col(0);
        gradients.rightCols(dim) = J.inverse().transpose();
        gradients.col(0)         = -gradients.rightCols(dim).rowwise().sum();
        const Eigen::MatrixXd forces = V * F * S * gradients;

        const State state = evaluate<dim>(network, u);
        EXPECT_NEAR(state.energy, energy, 1e-12 * energy);
        EXPECT_LT((state.gradient - forces.reshaped()).norm(),
                  1e-12 * forces.norm());
      }
  }

  TEST(BiquadraticSprings, WithAllCouplingsAreStVenantKirchhoffsMaterial)
  {
    check_st_venant_kirchhoff<2>(CellKind::triangle);
    check_st_venant_kirchhoff<3>(CellKind::tetrahedron);
  }
} // namespace
