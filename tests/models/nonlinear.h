#ifndef springfit_tests_models_nonlinear_h
#define springfit_tests_models_nonlinear_h

// What the tests of nonlinear bodies and their statics have in common.

#include <springfit/reference/cell_frame.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/elastic_body.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "meshes.h"

namespace springfit::oracle
{
  inline constexpr MaterialLaw hyperelastic[] = {
    MaterialLaw::st_venant_kirchhoff,
    MaterialLaw::neo_hookean,
    MaterialLaw::stable_neo_hookean};

  inline CellMaterial
  solid_material(const double E, const double nu)
  {
    const ElasticConstants constants = {E, nu, 1000.};
    return {constants, lame_constants(constants), 1., PlaneState::strain};
  }

  inline CellMaterial
  sheet_material(const double E, const double nu)
  {
    const ElasticConstants constants = {E, nu, 1000.};
    return {constants,
            lame_constants_plane_stress(constants),
            0.5,
            PlaneState::stress};
  }

  template <int dim>
  CellMaterial
  usual_material(const double E, const double nu)
  {
    return dim == 2 ? sheet_material(E, nu) : solid_material(E, nu);
  }

  inline Eigen::MatrixXd
  random_matrix(const int rows,
                const int columns,
                const double size,
                Random &random)
  {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&]() {
      return random(-size, size);
    });
  }

  /** A body at a state, its matrices dense. */
  struct DenseState
  {
    double energy;
    Eigen::MatrixXd forces; // dim x n_nodes
    Eigen::MatrixXd tangent;
    Eigen::MatrixXd convex_tangent;
  };

  inline DenseState
  evaluate(const BodyOfMembers &body, const Eigen::MatrixXd &u)
  {
    DenseState state;
    state.energy = body.energy(u);
    EXPECT_TRUE(std::isfinite(state.energy));
    state.forces = Eigen::MatrixXd::Zero(u.rows(), u.cols());
    body.add_forces(u, state.forces);

    NodePattern pattern(u.cols());
    body.add_to_pattern(pattern);
    TangentMatrix tangent(u.rows(), pattern);
    body.add_tangent(u, tangent);
    state.tangent = tangent.matrix();
    tangent.set_zero();
    body.add_convex_tangent(u, tangent);
    state.convex_tangent = tangent.matrix();
    return state;
  }

  /** Forces and tangent against central differences in random directions. */
  inline void
  check_derivatives(const BodyOfMembers &body,
                    const Eigen::MatrixXd &u,
                    const double size,
                    Random &random)
  {
    const auto state = evaluate(body, u);
    EXPECT_LT((state.tangent - state.tangent.transpose()).norm(),
              1e-12 * state.tangent.norm());
    for (unsigned int sample = 0; sample < 4; ++sample)
      {
        const Eigen::MatrixXd direction =
          random_matrix(u.rows(), u.cols(), 1., random);
        const double h     = 1e-5 * size;
        const auto plus    = evaluate(body, u + h * direction);
        const auto minus   = evaluate(body, u - h * direction);
        const double slope = (plus.energy - minus.energy) / (2. * h);
        EXPECT_NEAR(slope,
                    -state.forces.cwiseProduct(direction).sum(),
                    1e-7 * state.forces.norm() * direction.norm());
        const Eigen::MatrixXd change = (plus.forces - minus.forces) / (2. * h);
        EXPECT_LT(
          (change.reshaped() + state.tangent * direction.reshaped()).norm(),
          1e-7 * change.norm());
      }

    // The convex tangent leaves out nothing but negative eigenvalues.
    const auto smallest_eigenvalue = [](const Eigen::MatrixXd &symmetric) {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
               symmetric, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .minCoeff();
    };
    const double rounding = 1e-12 * state.tangent.norm();
    EXPECT_LT((state.convex_tangent - state.convex_tangent.transpose()).norm(),
              rounding);
    EXPECT_GT(smallest_eigenvalue(state.convex_tangent), -rounding);
    EXPECT_GT(smallest_eigenvalue(state.convex_tangent - state.tangent),
              -rounding);
  }

  /**
   * The shares of ranks are the body together, however its nodes are divided
   * among them; of a rank without nodes there is nothing.
   */
  inline void
  check_shares(const BodyOfMembers &body,
               const Eigen::MatrixXd &u,
               Random &random)
  {
    const auto whole = evaluate(body, u);
    for (const unsigned int n_ranks : {1u, 2u, 5u})
      {
        // The last rank has no nodes.
        std::vector<std::vector<bool>> owned(n_ranks + 1,
                                             std::vector<bool>(u.cols()));
        for (Eigen::Index v = 0; v < u.cols(); ++v)
          owned[static_cast<unsigned int>(random(0., n_ranks))][v] = true;
        auto sum = evaluate(*body.share(owned.back()), u);
        EXPECT_EQ(sum.energy, 0.);
        EXPECT_EQ(sum.forces.norm(), 0.);
        EXPECT_EQ(sum.tangent.norm(), 0.);
        EXPECT_EQ(sum.convex_tangent.norm(), 0.);
        owned.pop_back();
        for (const auto &nodes : owned)
          {
            const auto share = evaluate(*body.share(nodes), u);
            if (n_ranks > 1)
              {
                EXPECT_LT(share.tangent.norm(), whole.tangent.norm());
              }
            sum.energy += share.energy;
            sum.forces += share.forces;
            sum.tangent += share.tangent;
            sum.convex_tangent += share.convex_tangent;
          }
        EXPECT_NEAR(sum.energy, whole.energy, 1e-12 * std::abs(whole.energy));
        EXPECT_LT((sum.forces - whole.forces).norm(),
                  1e-12 * whole.forces.norm());
        EXPECT_LT((sum.tangent - whole.tangent).norm(),
                  1e-13 * whole.tangent.norm());
        EXPECT_LT((sum.convex_tangent - whole.convex_tangent).norm(),
                  1e-13 * whole.convex_tangent.norm());
      }
  }

  /** Distorted cells in a row would do; a box of them has inner nodes too. */
  template <int dim>
  std::unique_ptr<Mesh<dim>>
  distorted_box(Random &random)
  {
    return box_mesh<dim>(3, 0.03, 0.2, random);
  }

  /** A network with springs of every kind that cells have. */
  template <int dim>
  SpringNetwork
  full_network(const Mesh<dim> &mesh,
               Random &random,
               const SpringLaw law = SpringLaw::quadratic)
  {
    const auto &pairs   = node_pairs(mesh.cell_kind);
    const auto &triples = cell_angles(mesh.cell_kind);
    const double size   = 0.01;
    NetworkBuilder builder(nodes_of(mesh));
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const auto nodes             = nodes_of_cell<dim>(cell);
        const Eigen::MatrixXd points = cell_points<dim>(cell);
        Eigen::VectorXd k(pairs.size());
        for (Eigen::Index s = 0; s < k.size(); ++s)
          k[s] = random(0.5, 2.);
        builder.add(lengths_at_rest(points, pairs, k, law), nodes);
        builder.add(
          couplings_at_rest(points, pairs, {{0, 1, 0.3}, {1, 3, 0.2}}, law),
          nodes);
        builder.add(angles_at_rest(points,
                                   triples,
                                   Eigen::VectorXd::Constant(
                                     triples.size(), 0.1 * size * size)),
                    nodes);
        builder.add(volume_at_rest(points,
                                   mesh.cell_kind,
                                   1. / std::pow(size, 2 * dim - 2)),
                    nodes);
      }
    return builder.build();
  }

  template <int dim>
  Eigen::MatrixXd
  rotation();

  template <>
  inline Eigen::MatrixXd
  rotation<2>()
  {
    return Eigen::Rotation2Dd(2.).toRotationMatrix();
  }

  template <>
  inline Eigen::MatrixXd
  rotation<3>()
  {
    return Eigen::AngleAxisd(2., Eigen::Vector3d(1., 2., 3.).normalized())
      .toRotationMatrix();
  }

  template <int dim>
  void
  check_rigid_rotation(const BodyOfMembers &body,
                       const Eigen::MatrixXd &nodes,
                       Random &random)
  {
    const Eigen::MatrixXd rigid = (rotation<dim>() * nodes - nodes).colwise() +
                                  Eigen::VectorXd::Constant(dim, 0.1);
    const Eigen::MatrixXd deforming =
      nodes * 0.1 + random_matrix(dim, nodes.cols(), 1e-4, random);
    EXPECT_LT(evaluate(body, rigid).forces.norm(),
              1e-10 * evaluate(body, deforming).forces.norm());
  }
} // namespace springfit::oracle

#endif
