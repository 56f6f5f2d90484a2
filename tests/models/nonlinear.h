#ifndef springfit_tests_models_nonlinear_h
#define springfit_tests_models_nonlinear_h

// What the tests of nonlinear bodies and their statics have in common.

#include <springfit/reference/cell_matrices.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/elastic_body.h>
#include <springfit/springs/network.h>
#include <springfit/springs/volume.h>

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

  /** All terms of a body, dense. */
  struct DenseState
  {
    double energy;
    Eigen::MatrixXd forces; // dim x n_nodes
    Eigen::MatrixXd tangent;
  };

  inline DenseState
  evaluate(const ElasticBody &body, const Eigen::MatrixXd &u)
  {
    const Eigen::Index dim = u.rows();
    DenseState state{0.,
                     Eigen::MatrixXd::Zero(dim, u.cols()),
                     Eigen::MatrixXd::Zero(u.size(), u.size())};
    for (unsigned int t = 0; t < body.n_terms(); ++t)
      {
        const auto term = body.evaluate(t, u);
        EXPECT_TRUE(term);
        EXPECT_EQ(term->nodes[0], body.first_node(t));
        state.energy += term->energy;
        for (std::size_t a = 0; a < term->nodes.size(); ++a)
          {
            state.forces.col(term->nodes[a]) +=
              term->gradient.segment(dim * a, dim);
            for (std::size_t b = 0; b < term->nodes.size(); ++b)
              state.tangent.block(dim * term->nodes[a],
                                  dim * term->nodes[b],
                                  dim,
                                  dim) +=
                term->hessian.block(dim * a, dim * b, dim, dim);
          }
      }
    return state;
  }

  /** Forces and tangent against central differences in random directions. */
  inline void
  check_derivatives(const ElasticBody &body,
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
                    state.forces.cwiseProduct(direction).sum(),
                    1e-7 * state.forces.norm() * direction.norm());
        const Eigen::MatrixXd change = (plus.forces - minus.forces) / (2. * h);
        EXPECT_LT(
          (change.reshaped() - state.tangent * direction.reshaped()).norm(),
          1e-7 * change.norm());
      }
  }

  /** Distorted cells in a row would do; a box of them has inner nodes too. */
  template <int dim>
  std::unique_ptr<Mesh<dim>>
  distorted_box(Random &random)
  {
    return box_mesh<dim>(3, 0.03, 0.2, random);
  }

  /** A network with every kind of term on the cells of a mesh. */
  template <int dim>
  SpringNetwork
  full_network(const Mesh<dim> &mesh, Random &random)
  {
    const auto &pairs = node_pairs(mesh.cell_kind);
    NetworkBuilder builder(nodes_of(mesh));
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        std::vector<unsigned int> vertices;
        for (const unsigned int v : cell->vertex_indices())
          vertices.push_back(cell->vertex_index(v));
        Eigen::VectorXd k(pairs.size());
        for (Eigen::Index s = 0; s < k.size(); ++s)
          k[s] = random(0.5, 2.);
        builder.add_springs(vertices, pairs, k);
        builder.add_couplings(vertices, pairs, {{0, 1, 0.3}, {1, 3, 0.2}});
        const double size   = 0.01;
        const auto &triples = cell_angles(mesh.cell_kind);
        builder.add_angles(vertices,
                           triples,
                           Eigen::VectorXd::Constant(triples.size(),
                                                     0.1 * size * size));
        builder.add_volume(vertices,
                           1. / std::pow(size, 2 * dim - 2),
                           volume(cell_points<dim>(cell), mesh.cell_kind));
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
  check_rigid_rotation(const ElasticBody &body,
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
