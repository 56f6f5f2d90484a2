#include <springfit/reference/cell_matrices.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/linear_solver.h>
#include <springfit/response/network_body.h>
#include <springfit/response/newton.h>
#include <springfit/response/statics.h>
#include <springfit/springs/volume.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "meshes.h"

using namespace springfit;
using oracle::nodes_of;

namespace
{
  constexpr MaterialLaw hyperelastic[] = {MaterialLaw::st_venant_kirchhoff,
                                          MaterialLaw::neo_hookean};

  CellMaterial
  solid_material(const double E, const double nu)
  {
    const ElasticConstants constants = {E, nu, 1000.};
    return {constants, lame_constants(constants), 1., PlaneState::strain};
  }

  CellMaterial
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

  Eigen::MatrixXd
  random_matrix(const int rows,
                const int columns,
                const double size,
                oracle::Random &random)
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

  DenseState
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
  void
  check_derivatives(const ElasticBody &body,
                    const Eigen::MatrixXd &u,
                    const double size,
                    oracle::Random &random)
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
  distorted_box(oracle::Random &random)
  {
    return oracle::box_mesh<dim>(3, 0.03, 0.2, random);
  }

  /** A network with every kind of term on the cells of a mesh. */
  template <int dim>
  SpringNetwork
  full_network(const Mesh<dim> &mesh, oracle::Random &random)
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
        const double size = 0.01;
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
  Eigen::MatrixXd
  rotation<2>()
  {
    return Eigen::Rotation2Dd(2.).toRotationMatrix();
  }

  template <>
  Eigen::MatrixXd
  rotation<3>()
  {
    return Eigen::AngleAxisd(2., Eigen::Vector3d(1., 2., 3.).normalized())
      .toRotationMatrix();
  }

  template <int dim>
  void
  check_rigid_rotation(const ElasticBody &body,
                       const Eigen::MatrixXd &nodes,
                       oracle::Random &random)
  {
    const Eigen::MatrixXd rigid = (rotation<dim>() * nodes - nodes).colwise() +
                                  Eigen::VectorXd::Constant(dim, 0.1);
    const Eigen::MatrixXd deforming =
      nodes * 0.1 + random_matrix(dim, nodes.cols(), 1e-4, random);
    EXPECT_LT(evaluate(body, rigid).forces.norm(),
              1e-10 * evaluate(body, deforming).forces.norm());
  }
} // namespace

TEST(MaterialLaws, StressAndTangentAreDerivativesOfTheEnergy)
{
  oracle::Random random(21);
  const auto lame  = solid_material(2., 0.3).lame;
  const auto sheet = sheet_material(2., 0.3).lame;
  const auto shear = [](const auto &strain, const int n_dim) {
    // Voigt's vector of a strain, shears doubled: 11 22 (33) 12 23 31
    const int n_voigt = n_dim * (n_dim + 1) / 2;
    Eigen::VectorXd voigt(n_voigt);
    for (int d = 0; d < n_dim; ++d)
      voigt[d] = strain(d, d);
    for (int s = 0; s < n_voigt - n_dim; ++s)
      voigt[n_dim + s] = 2. * strain(s, (s + 1) % n_dim);
    return voigt;
  };
  const auto check = [&](const auto &law, const auto &F0) {
    using Tensor            = std::decay_t<decltype(F0)>;
    constexpr int dim       = Tensor::RowsAtCompileTime;
    const Tensor dF         = random_matrix(dim, dim, 1., random);
    const double h          = 1e-5;
    const auto state        = law(F0);
    const Tensor Fp         = F0 + h * dF;
    const Tensor Fm         = F0 - h * dF;
    const auto plus         = law(Fp);
    const auto minus        = law(Fm);
    const double expected   = (F0 * state.stress).cwiseProduct(dF).sum();
    const double difference = (plus.energy - minus.energy) / (2. * h);
    EXPECT_NEAR(difference, expected, 1e-8);
    const Tensor dE = (Fp.transpose() * Fp - Fm.transpose() * Fm) / (4. * h);
    const Tensor dS = (plus.stress - minus.stress) / (2. * h);
    Eigen::VectorXd voigt_stress = shear(dS, dim);
    voigt_stress.tail(voigt_stress.size() - dim) *= 0.5;
    EXPECT_LT((voigt_stress - state.tangent * shear(dE, dim)).norm(), 1e-8);
  };
  for (unsigned int sample = 0; sample < 10; ++sample)
    {
      const Eigen::Matrix2d F2 =
        Eigen::Matrix2d::Identity() + random_matrix(2, 2, 0.3, random);
      const Eigen::Matrix3d F3 =
        Eigen::Matrix3d::Identity() + random_matrix(3, 3, 0.2, random);
      check([&](const auto &F) { return st_venant_kirchhoff<2>(F, lame); }, F2);
      check([&](const auto &F) { return st_venant_kirchhoff<3>(F, lame); }, F3);
      check([&](const auto &F) { return *neo_hookean<2>(F, lame); }, F2);
      check([&](const auto &F) { return *neo_hookean<3>(F, lame); }, F3);
      check([&](const auto &F) { return *neo_hookean_plane_stress(F, sheet); },
            F2);
    }
  EXPECT_FALSE(neo_hookean<2>(Eigen::Vector2d(1., -1.).asDiagonal(), lame));
  EXPECT_FALSE(
    neo_hookean_plane_stress(Eigen::Vector2d(1., -1.).asDiagonal(), sheet));
}

TEST(MaterialLaws, PlaneStressIsThreeDimensionalWithoutStressAcross)
{
  for (const double nu : {0., 0.3, 0.49})
    {
      Eigen::Matrix2d F;
      F << 1.3, 0.2, -0.1, 0.9;
      const auto sheet =
        neo_hookean_plane_stress(F, sheet_material(2., nu).lame);
      // Bisection for the stretch across the plane.
      double low = 0.1, high = 3.;
      Eigen::Matrix3d F3     = Eigen::Matrix3d::Identity();
      F3.topLeftCorner(2, 2) = F;
      for (unsigned int step = 0; step < 60; ++step)
        {
          F3(2, 2)  = 0.5 * (low + high);
          (neo_hookean<3>(F3, solid_material(2., nu).lame)->stress(2, 2) > 0.
             ? high
             : low) = F3(2, 2);
        }
      const auto solid = neo_hookean<3>(F3, solid_material(2., nu).lame);
      EXPECT_LT((solid->stress.topLeftCorner(2, 2) - sheet->stress).norm(),
                1e-12);
      EXPECT_NEAR(solid->energy, sheet->energy, 1e-12);
    }
  // The limit nu = 0.5 keeps the volume.
  const Eigen::Matrix2d F = Eigen::Vector2d(1.5, 0.8).asDiagonal();
  const auto state = neo_hookean_plane_stress(F, sheet_material(3., 0.5).lame);
  EXPECT_NEAR(state->energy,
              0.5 * (1.5 * 1.5 + 0.64 + 1. / (1.44) - 3.),
              1e-12);
}

namespace
{
  template <int dim>
  void
  check_finite_elements()
  {
    oracle::Random random(22);
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
  oracle::Random random(23);
  Eigen::MatrixXd triangle(2, 3), tetrahedron(3, 4);
  triangle << 0., 1., 0.2, 0., 0.1, 0.9;
  tetrahedron << 0., 1., 0.2, 0.1, 0., 0.1, 0.9, 0.2, 0., 0., 0.1, 1.1;
  for (const auto law : hyperelastic)
    {
      const auto flat =
        oracle::single_cell_mesh<2>(CellKind::triangle, triangle);
      const auto flat_element = make_element<2>(flat->cell_kind);
      check_derivatives(FiniteElementBody<2>(*flat,
                                             flat_element,
                                             {{0, sheet_material(1e4, 0.3)}},
                                             law),
                        random_matrix(2, 3, 0.1, random),
                        1.,
                        random);
      const auto solid =
        oracle::single_cell_mesh<3>(CellKind::tetrahedron, tetrahedron);
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

TEST(NonlinearFiniteElements, UniaxialNeoHookeanStress)
{
  oracle::Random random(24);
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
        force += state.forces(0, v);
      lateral = std::max(lateral, state.forces.col(v).tail(2).norm());
    }
  EXPECT_NEAR(force, P * 0.03 * 0.03, 1e-10 * force);
  EXPECT_LT(lateral, 1e-10 * force);
}

namespace
{
  /** A bar along x of side 0.03, held at x = 0, pulled with a stress. */
  template <int dim>
  struct Bar
  {
    oracle::Random random{25};
    std::unique_ptr<Mesh<dim>> mesh =
      oracle::box_mesh<dim>(3, 0.03, 0.2, random);
    Element<dim> element  = make_element<dim>(mesh->cell_kind);
    Eigen::MatrixXd nodes = nodes_of(*mesh);
    Discretization<dim> discretization{*mesh, held(), MPI_COMM_SELF};

    std::vector<bool>
    held() const
    {
      std::vector<bool> fixed;
      for (Eigen::Index v = 0; v < nodes.cols(); ++v)
        fixed.push_back(nodes(0, v) < 1e-9);
      return fixed;
    }

    Eigen::MatrixXd
    pull(const double stress, const double thickness) const
    {
      Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(dim, nodes.cols());
      const double cell      = 0.01;
      for (Eigen::Index v = 0; v < nodes.cols(); ++v)
        if (nodes(0, v) > 0.03 - 1e-9)
          {
            double area = thickness;
            for (int d = 1; d < dim; ++d)
              area *= nodes(d, v) < 1e-9 || nodes(d, v) > 0.03 - 1e-9
                        ? 0.5 * cell
                        : cell;
            forces(0, v) = stress * area;
          }
      return forces;
    }
  };
} // namespace

TEST(NonlinearStatics, NeoHookeanBarWithoutLateralContraction)
{
  // nu = 0: P = mu (s - 1/s), s the stretch.
  const Bar<3> bar;
  const auto statics = oracle::make_step<Statics<3>>(
    "subsection Response\n set Material law = neo-hookean\nend");
  for (const double P : {8e3, -1.5e3})
    {
      const auto found = statics
                           ->finite_elements(bar.discretization,
                                             bar.element,
                                             {{0, solid_material(1e4, 0.)}})
                           ->respond(bar.pull(P, 1.));
      const double p           = P / 5e3;
      const double s           = 0.5 * (p + std::sqrt(p * p + 4.));
      Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3, bar.nodes.cols());
      expected.row(0)          = (s - 1.) * bar.nodes.row(0);
      EXPECT_EQ(found.load_fraction, 1.);
      EXPECT_LT((found.displacement - expected).norm(), 1e-8 * expected.norm());
    }
}

TEST(NonlinearStatics, TinyLoadsGiveTheLinearResponse)
{
  // The forces' rounding errors are a part of the load far above the
  // tolerance; strains of 1e-8 are what sets the models apart.
  const Bar<3> bar;
  const MaterialTable materials = {{0, solid_material(1e4, 0.3)}};
  oracle::Random random(29);
  const auto network = full_network(*bar.mesh, random);
  const auto statics = oracle::make_step<Statics<3>>(
    "subsection Response\n set Material law = neo-hookean\n"
    " set Tolerance = 1e-15\nend");
  const auto check =
    [&](const Model &linear, const Model &nonlinear, const double stress) {
      const Eigen::MatrixXd forces = bar.pull(stress, 1.);
      const auto expected          = linear.respond(forces);
      const auto found             = nonlinear.respond(forces);
      EXPECT_EQ(found.failure, "");
      EXPECT_LT((found.displacement - expected.displacement).norm(),
                1e-6 * expected.displacement.norm());
    };
  check(*statics->linear_finite_elements(bar.discretization,
                                         bar.element,
                                         materials),
        *statics->finite_elements(bar.discretization, bar.element, materials),
        1e-4);
  const auto springs = [&](const Kinematics kinematics) {
    return statics->springs(
      bar.discretization, bar.element, network, "test", kinematics);
  };
  // Springs of 1 N/m in cells of 0.01 m.
  check(*springs(Kinematics::linear), *springs(Kinematics::nonlinear), 1e-6);
}

TEST(NonlinearStatics, AColumnBucklesWhereEulerSays)
{
  // A cantilever as thick as it is long is no slender column, but Euler's
  // stress pi^2 E / 48 is near.
  const Bar<3> bar;
  const auto statics = oracle::make_step<Statics<3>>(
    "subsection Response\n set Material law = neo-hookean\nend");
  const auto found = statics
                       ->finite_elements(bar.discretization,
                                         bar.element,
                                         {{0, solid_material(1e4, 0.)}})
                       ->respond(bar.pull(-6e3, 1.));
  const double euler = M_PI * M_PI * 1e4 / 48.;
  EXPECT_NEAR(found.load_fraction * 6e3, euler, 0.3 * euler);
  EXPECT_NE(found.failure.find("buckles"), std::string::npos);
}

TEST(NonlinearStatics, ALoadBeyondTheLimitSaysHowFarItGot)
{
  // St. Venant-Kirchhoff, nu = 0: P = E (s^3 - s) / 2 has its minimum
  // -E / (3 sqrt 3) at s = 1 / sqrt 3; no material carries more compression.
  // On one layer across nothing can buckle before.
  const Bar<2> bar;
  const auto statics = oracle::make_step<Statics<2>>(
    "subsection Response\n set Material law = st venant-kirchhoff\nend");
  const auto model   = statics->finite_elements(bar.discretization,
                                              bar.element,
                                              {{0, sheet_material(1e4, 0.)}});
  const double limit = 1e4 / (3. * std::sqrt(3.));
  const auto carried = model->respond(bar.pull(-0.5 * limit, 0.5));
  EXPECT_TRUE(carried.failure.empty());
  const auto found = model->respond(bar.pull(-2. * limit, 0.5));
  EXPECT_LE(found.load_fraction, 0.5);
  EXPECT_GT(found.load_fraction, 0.25);
  EXPECT_NE(found.failure.find("% of the load"), std::string::npos);
  EXPECT_TRUE(found.displacement.allFinite());
  EXPECT_GT(found.displacement.norm(), 0.);
}

TEST(Newton, ConvergesQuadratically)
{
  const Bar<3> bar;
  const auto material                = solid_material(1e4, 0.3);
  const SolverFactory<3> make_solver = [](const auto &matrix) {
    return make_direct_solver<3>(matrix);
  };
  Eigen::MatrixXd forces = bar.pull(1e3, 1.);
  forces.row(1)          = 0.3 * forces.row(0);
  oracle::Random random(26);
  const auto network = full_network(*bar.mesh, random);
  const NetworkBody<3> springs(network);
  for (const auto law : hyperelastic)
    {
      const FiniteElementBody<3> cells(*bar.mesh,
                                       bar.element,
                                       {{0, material}},
                                       law);
      for (const ElasticBody *body :
           {static_cast<const ElasticBody *>(&cells),
            static_cast<const ElasticBody *>(&springs)})
        {
          const double scale = body == &springs ? 1e-2 : 1.;
          const auto result =
            newton<3>(bar.discretization,
                      *body,
                      make_solver,
                      bar.discretization.to_vector(scale * forces),
                      Eigen::MatrixXd::Zero(3, bar.nodes.cols()),
                      1e-11);
          EXPECT_EQ(result.failure, "");
          const auto &r = result.residuals;
          ASSERT_GE(r.size(), 4u);
          // The order from the last three residuals above rounding.
          std::size_t last = r.size() - 1;
          while (last > 3 && r[last] < 1e-12)
            --last;
          const double order = std::log(r[last] / r[last - 1]) /
                               std::log(r[last - 1] / r[last - 2]);
          EXPECT_GT(order, 1.7);
        }
    }
}

namespace
{
  template <int dim>
  void
  check_network()
  {
    oracle::Random random(27);
    const auto mesh    = distorted_box<dim>(random);
    const auto network = full_network(*mesh, random);
    EXPECT_FALSE(network.couplings.empty());
    EXPECT_FALSE(network.volumes.empty());
    const NetworkBody<dim> body(network);
    check_derivatives(body,
                      random_matrix(dim, network.nodes.cols(), 1e-3, random),
                      0.01,
                      random);
    check_rigid_rotation<dim>(body, network.nodes, random);
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
  oracle::Random random(28);
  const auto mesh   = oracle::box_mesh<3>(3, 0.03, 0., random);
  const auto nodes  = nodes_of(*mesh);
  const auto &pairs = node_pairs(mesh->cell_kind);
  NetworkBuilder builder(nodes);
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    {
      std::vector<unsigned int> vertices;
      for (const unsigned int v : cell->vertex_indices())
        vertices.push_back(cell->vertex_index(v));
      builder.add_springs(vertices, pairs, Eigen::VectorXd::Ones(pairs.size()));
    }
  const auto network = builder.build();
  const auto state =
    evaluate(NetworkBody<3>(network), random_matrix(3, 3, 0.3, random) * nodes);
  for (Eigen::Index v = 0; v < nodes.cols(); ++v)
    if ((nodes.col(v).array() > 1e-6).all() &&
        (nodes.col(v).array() < 0.03 - 1e-6).all())
      {
        EXPECT_LT(state.forces.col(v).norm(), 1e-10 * state.forces.norm());
      }
}

namespace
{
  /** Two springs between (-1, 0), (1, 0), both held, and (0, h). */
  SpringNetwork
  shallow_truss(const Mesh<2> &mesh, const double k)
  {
    NetworkBuilder builder(nodes_of(mesh));
    builder.add_springs({0, 1, 2},
                        node_pairs(CellKind::triangle),
                        Eigen::Vector3d(1., k, k));
    return builder.build();
  }
} // namespace

TEST(NonlinearSprings, ShallowTrussFollowsItsCurveUpToTheLimit)
{
  // von Mises' truss: with y the height of the apex and l = sqrt(1 + y^2) the
  // load is F = 2 k (L - l) y / l.
  const double h = 0.5, k = 10.;
  Eigen::MatrixXd points(2, 3);
  points << -1., 1., 0., 0., 0., h;
  const auto mesh    = oracle::single_cell_mesh<2>(CellKind::triangle, points);
  const auto element = make_element<2>(mesh->cell_kind);
  const auto network = shallow_truss(*mesh, k);
  const Discretization<2> discretization(*mesh,
                                         {true, true, false},
                                         MPI_COMM_SELF);
  const auto statics = oracle::make_step<Statics<2>>("");
  const auto model   = statics->springs(
    discretization, element, network, "test", Kinematics::nonlinear);
  const double L   = std::sqrt(1. + h * h);
  const auto force = [&](const double y) {
    const double l = std::sqrt(1. + y * y);
    return 2. * k * (L - l) * y / l;
  };
  double limit = 0.;
  for (double y = 0.; y < h; y += 1e-4)
    limit = std::max(limit, force(y));

  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(2, 3);
  forces(1, 2)           = -force(0.45);
  const auto found       = model->respond(forces);
  EXPECT_TRUE(found.failure.empty());
  EXPECT_NEAR(h + found.displacement(1, 2), 0.45, 1e-9);
  EXPECT_NEAR(found.displacement(0, 2), 0., 1e-9);

  // Beyond the limit the truss snaps through: the cell turns inside out.
  forces(1, 2)       = -1.5 * limit;
  const auto snapped = model->respond(forces);
  EXPECT_LE(snapped.load_fraction, 1. / 1.5);
  EXPECT_GT(snapped.load_fraction, 1. / 1.5 - 0.02);
  EXPECT_NE(snapped.failure.find("turn inside out"), std::string::npos);
}
