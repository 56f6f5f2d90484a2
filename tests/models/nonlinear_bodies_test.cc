#include <springfit/response/discretization.h>
#include <springfit/response/distributed_body.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/network_body.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nonlinear.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  template <int dim>
  void
  check_finite_elements()
  {
    Random random(22);
    const auto mesh               = distorted_box<dim>(random);
    const auto element            = make_element<dim>(mesh->cell_kind);
    const auto material           = usual_material<dim>(1e4, 0.3);
    const auto nodes              = nodes_of(*mesh);
    const Eigen::MatrixXd zero    = Eigen::MatrixXd::Zero(dim, nodes.cols());
    const MaterialTable materials = {{0, material}};

    const auto linear = evaluate(
      FiniteElementBody<dim>(*mesh, element, materials, MaterialLaw::linear),
      zero);
    for (const auto law : hyperelastic)
      {
        const FiniteElementBody<dim> body(*mesh, element, materials, law);
        const auto rest = evaluate(body, zero);
        EXPECT_LT(rest.forces.norm(), 1e-12);
        EXPECT_LT((rest.tangent - linear.tangent).norm(),
                  1e-12 * linear.tangent.norm());
        check_derivatives(body,
                          random_matrix(dim, nodes.cols(), 1e-3, random),
                          0.01,
                          random);
        check_shares(body,
                     random_matrix(dim, nodes.cols(), 1e-3, random),
                     random);
        check_rigid_rotation<dim>(body, nodes, random);

        // Patch test: an affine deformation leaves no force on inner nodes.
        const Eigen::MatrixXd gradient = random_matrix(dim, dim, 0.3, random);
        const auto affine              = evaluate(body, gradient * nodes);
        double inner                   = 0.;
        unsigned int n_inner           = 0;
        for (Eigen::Index v = 0; v < nodes.cols(); ++v)
          if ((nodes.col(v).array() > 1e-6).all() &&
              (nodes.col(v).array() < 0.03 - 1e-6).all())
            {
              inner = std::max(inner, affine.forces.col(v).norm());
              ++n_inner;
            }
        EXPECT_EQ(n_inner, dim == 2 ? 4u : 8u);
        EXPECT_LT(inner, 1e-10 * affine.forces.norm());
      }
  }
} // namespace

TEST(NonlinearFiniteElements, AreConsistentRigidAndPassThePatchTest)
{
  check_finite_elements<2>();
  check_finite_elements<3>();
}

TEST(NonlinearFiniteElements, SimplicesAreConsistentToo)
{
  Random random(23);
  Eigen::MatrixXd triangle(2, 3), tetrahedron(3, 4);
  triangle << 0., 1., 0.2, 0., 0.1, 0.9;
  tetrahedron << 0., 1., 0.2, 0.1, 0., 0.1, 0.9, 0.2, 0., 0., 0.1, 1.1;
  for (const auto law : hyperelastic)
    {
      const auto flat = single_cell_mesh<2>(CellKind::triangle, triangle);
      const auto flat_element = make_element<2>(flat->cell_kind);
      check_derivatives(FiniteElementBody<2>(*flat,
                                             flat_element,
                                             {{0, sheet_material(1e4, 0.3)}},
                                             law),
                        random_matrix(2, 3, 0.1, random),
                        1.,
                        random);
      const auto solid =
        single_cell_mesh<3>(CellKind::tetrahedron, tetrahedron);
      const auto solid_element = make_element<3>(solid->cell_kind);
      check_derivatives(FiniteElementBody<3>(*solid,
                                             solid_element,
                                             {{0, solid_material(1e4, 0.3)}},
                                             law),
                        random_matrix(3, 4, 0.1, random),
                        1.,
                        random);
    }
}

namespace
{
  template <int dim>
  void
  check_inverted_cells()
  {
    Random random(29);
    const auto mesh    = distorted_box<dim>(random);
    const auto element = make_element<dim>(mesh->cell_kind);
    const auto nodes   = nodes_of(*mesh);
    const FiniteElementBody<dim> body(*mesh,
                                      element,
                                      {{0, usual_material<dim>(1e4, 0.3)}},
                                      MaterialLaw::stable_neo_hookean);
    const auto n_cells = mesh->triangulation.n_active_cells();

    // Pressed into a plane, mirrored, and in disorder.
    Eigen::MatrixXd flat = Eigen::MatrixXd::Zero(dim, nodes.cols());
    flat.row(0)          = -nodes.row(0);
    const Eigen::MatrixXd jumbled =
      random_matrix(dim, nodes.cols(), 0.02, random);
    const auto n_inverted = [&](const Eigen::MatrixXd &u) {
      return n_inverted_cells(*mesh, element, u);
    };
    EXPECT_EQ(n_inverted(flat), n_cells);
    EXPECT_EQ(n_inverted(2. * flat), n_cells);
    EXPECT_GT(n_inverted(jumbled), 0u);
    check_derivatives(body, flat, 0.01, random);
    check_derivatives(body, 2. * flat, 0.01, random);
    check_derivatives(body, jumbled, 0.01, random);
  }
} // namespace

TEST(NonlinearFiniteElements, StableNeoHookeanCellsMayBeInverted)
{
  check_inverted_cells<2>();
  check_inverted_cells<3>();
}

TEST(NonlinearFiniteElements, UniaxialNeoHookeanStress)
{
  Random random(24);
  const auto mesh         = distorted_box<3>(random);
  const auto element      = make_element<3>(mesh->cell_kind);
  const auto material     = solid_material(1e4, 0.3);
  const auto [lambda, mu] = material.lame;
  const FiniteElementBody<3> body(*mesh,
                                  element,
                                  {{0, material}},
                                  MaterialLaw::neo_hookean);
  const auto nodes = nodes_of(*mesh);

  const double stretch = 1.4;
  // mu (t^2 - 1) + lambda ln(stretch t^2) = 0 for the lateral stretch t.
  double low = 0.5, high = 1.;
  for (unsigned int step = 0; step < 60; ++step)
    {
      const double t = 0.5 * (low + high);
      (mu * (t * t - 1.) + lambda * std::log(stretch * t * t) > 0. ? high
                                                                   : low) = t;
    }
  const double log_J = std::log(stretch * low * low);
  const double P     = mu * (stretch - 1. / stretch) + lambda * log_J / stretch;

  const Eigen::Vector3d stretches(stretch, low, low);
  const auto state = evaluate(body, stretches.asDiagonal() * nodes - nodes);
  double force = 0., lateral = 0.;
  for (Eigen::Index v = 0; v < nodes.cols(); ++v)
    {
      if (nodes(0, v) > 0.03 - 1e-9)
        force -= state.forces(0, v);
      lateral = std::max(lateral, state.forces.col(v).tail(2).norm());
    }
  EXPECT_NEAR(force, P * 0.03 * 0.03, 1e-10 * force);
  EXPECT_LT(lateral, 1e-10 * force);
}

namespace
{
  template <int dim>
  void
  check_network()
  {
    Random random(27);
    const auto mesh = distorted_box<dim>(random);
    for (const auto law : {SpringLaw::quadratic, SpringLaw::biquadratic})
      {
        const auto network = full_network(*mesh, random, law);
        ASSERT_EQ(network.families.size(), 4u);
        for (const auto &family : network.families)
          EXPECT_GT(family.size(), 0u);
        const NetworkBody body(network);
        check_derivatives(
          body,
          random_matrix(dim, network.nodes.cols(), 1e-3, random),
          0.01,
          random);
        check_shares(body,
                     random_matrix(dim, network.nodes.cols(), 1e-3, random),
                     random);
        check_rigid_rotation<dim>(body, network.nodes, random);
      }
  }
} // namespace

TEST(NonlinearSprings, AreConsistentAndRigid)
{
  check_network<2>();
  check_network<3>();
}

TEST(NonlinearSprings, PatchTestOnARegularMesh)
{
  // Every inner node of a regular mesh is a centre of symmetry, also after an
  // affine deformation.
  Random random(28);
  const auto mesh   = box_mesh<3>(3, 0.03, 0., random);
  const auto nodes  = nodes_of(*mesh);
  const auto &pairs = node_pairs(mesh->cell_kind);
  NetworkBuilder builder(nodes);
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    {
      builder.add(lengths_at_rest(cell_points<3>(cell),
                                  pairs,
                                  Eigen::VectorXd::Ones(pairs.size()),
                                  SpringLaw::quadratic),
                  nodes_of_cell<3>(cell));
    }
  const auto network = builder.build();
  const auto state =
    evaluate(NetworkBody(network), random_matrix(3, 3, 0.3, random) * nodes);
  for (Eigen::Index v = 0; v < nodes.cols(); ++v)
    if ((nodes.col(v).array() > 1e-6).all() &&
        (nodes.col(v).array() < 0.03 - 1e-6).all())
      {
        EXPECT_LT(state.forces.col(v).norm(), 1e-10 * state.forces.norm());
      }
}

namespace
{
  /** A body on the unknowns of a discretization is that of the nodes. */
  template <int dim>
  void
  check_distributed(const Mesh<dim> &mesh,
                    const BodyOfMembers &body,
                    const Eigen::MatrixXd &u)
  {
    std::vector<bool> fixed;
    for (Eigen::Index v = 0; v < u.cols(); ++v)
      fixed.push_back(v % 3 == 1);
    const Discretization<dim> discretization(mesh,
                                             unknowns_of(dim, fixed),
                                             MPI_COMM_SELF);
    DistributedBody<dim> distributed(discretization, body);
    const auto state = evaluate(body, u);
    EXPECT_NEAR(distributed.energy(u),
                state.energy,
                1e-13 * std::abs(state.energy));

    Eigen::MatrixXd forces = state.forces;
    for (Eigen::Index v = 0; v < u.cols(); ++v)
      if (fixed[v])
        forces.col(v).setZero();
    EXPECT_LT((discretization.to_nodal(distributed.forces(u)) - forces).norm(),
              1e-13 * forces.norm());

    typename Discretization<dim>::Matrix matrix;
    discretization.initialize(matrix);
    const auto check_matrix = [&](const Eigen::MatrixXd &expected) {
      double error = 0.;
      for (Eigen::Index i = 0; i < u.size(); ++i)
        for (Eigen::Index j = 0; j < u.size(); ++j)
          {
            const double entry =
              matrix.el(discretization.dof(i / dim, i % dim),
                        discretization.dof(j / dim, j % dim));
            if (!fixed[i / dim] && !fixed[j / dim])
              error = std::max(error, std::abs(entry - expected(i, j)));
            else if (i != j)
              EXPECT_EQ(entry, 0.);
            else
              EXPECT_GT(entry, 0.);
          }
      EXPECT_LT(error, 1e-13 * expected.cwiseAbs().maxCoeff());
    };
    // What the matrix held before does not matter.
    distributed.convex_tangent(u, matrix);
    check_matrix(state.convex_tangent);
    distributed.tangent(u, matrix);
    check_matrix(state.tangent);
  }

  template <int dim>
  void
  check_distributed_models()
  {
    Random random(30);
    const auto mesh    = distorted_box<dim>(random);
    const auto element = make_element<dim>(mesh->cell_kind);
    const Eigen::MatrixXd u =
      random_matrix(dim, nodes_of(*mesh).cols(), 1e-3, random);
    check_distributed<dim>(*mesh, NetworkBody(full_network(*mesh, random)), u);
    check_distributed<dim>(
      *mesh,
      FiniteElementBody<dim>(*mesh,
                             element,
                             {{0, usual_material<dim>(1e4, 0.3)}},
                             MaterialLaw::neo_hookean),
      u);
  }
} // namespace

TEST(DistributedBody, IsTheBodyOnItsUnknowns)
{
  check_distributed_models<2>();
  check_distributed_models<3>();
}
