#include <springfit/comparison/delivered_constants.h>
#include <springfit/comparison/errors.h>
#include <springfit/mesh/objects.h>
#include <springfit/response/loads.h>
#include <springfit/response/network_body.h>
#include <springfit/response/region.h>
#include <springfit/response/stability.h>
#include <springfit/response/statics.h>
#include <springfit/springs/rest_families.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshes.h"

using namespace springfit;
using oracle::nodes_of;

namespace
{
  const std::string fixed_1_loaded_2 =
    " set Fixed boundaries = 1\n set Loaded boundaries = 2\nend";

  template <int dim>
  MaterialTable
  one_material(const double E, const double nu, const double thickness)
  {
    const ElasticConstants constants = {E, nu, 1000.};
    return {{0,
             {constants,
              dim == 2 ? lame_constants_plane_stress(constants)
                       : lame_constants(constants),
              thickness}}};
  }

  /** Springs at rest between nodes of 1 kg. */
  SpringNetwork
  springs_at_rest(const Eigen::MatrixXd &nodes,
                  const std::vector<NodePair> &pairs,
                  const Eigen::VectorXd &k)
  {
    return {nodes,
            {lengths_at_rest(nodes, pairs, k, SpringLaw::quadratic)},
            std::vector<double>(nodes.cols(), 1.)};
  }

  unsigned int
  n_unstable_of_springs(const SpringNetwork &network,
                        const std::vector<bool> &fixed)
  {
    return n_unstable_motions(NetworkBody(network),
                              Eigen::MatrixXd::Zero(network.nodes.rows(),
                                                    network.nodes.cols()),
                              oracle::unknowns_of(network.nodes.rows(), fixed));
  }

  /** A bar without lateral contraction stretches by F L / (E A). */
  template <int dim>
  void
  stretch_a_bar(const std::string &solver)
  {
    oracle::Random random(4);
    const double E = 2e4, L = 0.03, h = dim == 2 ? 0.5 : 1.;
    const auto mesh    = oracle::box_mesh<dim>(3, L, 0.2, random);
    const auto element = make_element<dim>(mesh->cell_kind);
    const auto loads   = oracle::make_step<Loads<dim>>(
      "subsection Loads\n set Cases = tension\n" + fixed_1_loaded_2);
    const auto loading =
      loads->resolve(*mesh, element, one_material<dim>(E, 0., h));
    const auto statics = oracle::make_step<Statics<dim>>(
      "subsection Response\n set Solver = " + solver +
      "\n set Tolerance = 1e-13\nend");
    const Discretization<dim> discretization(*mesh,
                                             loading.held,
                                             MPI_COMM_SELF);
    const auto load = loading.cases.front().load;
    const auto u    = statics
                     ->finite_elements(discretization,
                                       *mesh,
                                       element,
                                       one_material<dim>(E, 0., h))
                     ->respond(load)
                     .displacement;

    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(dim, u.cols());
    expected.row(0)          = nodes_of(*mesh).row(0) / E; // 1 Pa
    EXPECT_LT((u - expected).norm(), 1e-9 * expected.norm());

    const auto delivered = delivered_constants(
      *mesh, element, loading.pull->axis, u, load.forces, h);
    // In space the slab is cut from plane-faced simplices, which the faces of
    // moved vertices are not quite.
    EXPECT_NEAR(delivered->youngs_modulus, E, (dim == 2 ? 1e-7 : 1e-3) * E);
    EXPECT_NEAR(delivered->poissons_ratio, 0., 1e-9);
  }
} // namespace

TEST(FiniteElements, StretchABarExactly)
{
  stretch_a_bar<2>("direct");
  stretch_a_bar<3>("direct");
  stretch_a_bar<2>("cg");
  stretch_a_bar<3>("cg");
}

TEST(Springs, TangentIsTheSumOverSprings)
{
  // Two springs in a row along x, and two that keep the middle node on it:
  // the node in the middle moves by f / (k1 + k2).
  MeshDescription description;
  description.cell_kind    = CellKind::triangle;
  description.vertices     = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}};
  description.cells        = {0, 1, 2};
  description.material_ids = {0};
  const auto mesh          = build_mesh<2>(description);

  const auto network = springs_at_rest(nodes_of(*mesh),
                                       {{{0, 1}}, {{0, 2}}, {{1, 2}}},
                                       Eigen::Vector3d(3., 5., 7.));
  const Discretization<2> discretization(
    *mesh, oracle::unknowns_of(2, {true, false, true}), MPI_COMM_SELF);
  const auto statics     = oracle::make_step<Statics<2>>("");
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(2, 3);
  forces.col(1) << 0.2, 0.1;
  const auto element = make_element<2>(mesh->cell_kind);
  const auto u =
    statics
      ->springs(
        discretization, *mesh, element, network, "test", Kinematics::linear)
      ->respond(load_of_forces(forces))
      .displacement;
  Eigen::Matrix2d K;
  K << 3. + 3.5, -3.5, -3.5, 3.5;
  const Eigen::Vector2d expected = K.inverse() * Eigen::Vector2d(0.2, 0.1);
  EXPECT_LT((u.col(1) - expected).norm(), 1e-12);
  EXPECT_EQ(u.col(0).norm() + u.col(2).norm(), 0.);
}

TEST(Springs, AMechanismIsRefused)
{
  oracle::Random random(5);
  const auto mesh = oracle::box_mesh<2>(1, 1., 0., random);
  // A square without diagonals shears freely.
  const auto network = springs_at_rest(nodes_of(*mesh),
                                       {{{0, 1}}, {{0, 2}}, {{1, 3}}, {{2, 3}}},
                                       Eigen::Vector4d::Ones());
  const Discretization<2> discretization(
    *mesh, oracle::unknowns_of(2, {true, true, false, false}), MPI_COMM_SELF);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(2, 4);
  forces.row(0) << 0., 0., 1., 1.;
  const auto element = make_element<2>(mesh->cell_kind);
  const auto statics = oracle::make_step<Statics<2>>("");
  EXPECT_THROW(
    statics
      ->springs(
        discretization, *mesh, element, network, "test", Kinematics::linear)
      ->respond(load_of_forces(forces)),
    RunError);
}

TEST(Springs, UnstableMotionsAreCounted)
{
  // One free node between three fixed ones: the tangent is k_x and k_y.
  Eigen::MatrixXd corner(2, 3);
  corner << 0., 1., 1., //
    0., 0., 1.;
  const std::vector<bool> fixed = {true, false, true};
  const auto n_unstable         = [&](const double k_x, const double k_y) {
    return n_unstable_of_springs(springs_at_rest(corner,
                                                 {{{0, 1}}, {{1, 2}}},
                                                 Eigen::Vector2d(k_x, k_y)),
                                 fixed);
  };
  EXPECT_EQ(n_unstable(2., 3.), 0u);
  EXPECT_EQ(n_unstable(2., -3.), 1u);
  EXPECT_EQ(n_unstable(-2., -3.), 2u);

  // Against dense eigenvalues, with springs of both signs.
  oracle::Random random(11);
  const auto mesh             = oracle::box_mesh<3>(2, 1., 0.2, random);
  const Eigen::MatrixXd nodes = nodes_of(*mesh);
  std::vector<NodePair> pairs;
  for (unsigned int i = 0; i < 27; ++i)
    for (unsigned int j = i + 1; j < 27; ++j)
      pairs.push_back({{i, j}});
  Eigen::VectorXd k(pairs.size());
  for (double &stiffness : k)
    stiffness = random(-0.4, 1.);
  std::vector<bool> held(27, false);
  std::fill_n(held.begin(), 9, true);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(81, 81);
  for (std::size_t s = 0; s < pairs.size(); ++s)
    {
      const auto [i, j]       = pairs[s];
      Eigen::VectorXd b       = Eigen::VectorXd::Zero(81);
      const Eigen::VectorXd n = (nodes.col(j) - nodes.col(i)).normalized();
      b.segment(3 * i, 3)     = -n;
      b.segment(3 * j, 3)     = n;
      K += k[s] * b * b.transpose();
    }
  const Eigen::VectorXd eigenvalues =
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K.bottomRightCorner(54, 54))
      .eigenvalues();
  const unsigned int expected = (eigenvalues.array() < 0.).count();
  EXPECT_GT(expected, 0u);
  EXPECT_EQ(n_unstable_of_springs(springs_at_rest(nodes, pairs, k), held),
            expected);
}

TEST(DeliveredConstants, AreNothingWhereNothingIsStrained)
{
  oracle::Random random(12);
  const auto mesh    = oracle::box_mesh<2>(3, 1., 0., random);
  const auto element = make_element<2>(mesh->cell_kind);
  Eigen::MatrixXd u =
    Eigen::MatrixXd::Zero(2, mesh->triangulation.n_vertices());
  u(0, 3) = 1.; // a corner, outside the middle third
  EXPECT_FALSE(
    delivered_constants(*mesh, element, Eigen::Vector2d::UnitX(), u, u, 1.));
}

namespace
{
  /**
   * A specimen whose straight part is strained uniformly. Of structured cells,
   * which have vertices at the part's ends, the rest is not strained axially.
   */
  template <int dim>
  void
  pull_a_specimen(const CellKind kind, const Eigen::VectorXd &axis)
  {
    const double B = 0.01, E = 1e4, nu = 0.3, strain = 0.02;
    const double thickness = dim == 2 ? 0.5 : 1.;
    ObjectRequest request{dim, dim, kind, {16. * B, 3. * B}, {0.006}, "", 1.};
    if (dim == 3)
      request.size.push_back(B);
    const auto mesh =
      build_mesh<dim>(find_object("specimen").describe(request));
    const auto element = make_element<dim>(kind);

    const Eigen::MatrixXd nodes = nodes_of(*mesh);
    Eigen::MatrixXd u           = -nu * strain * nodes;
    for (Eigen::Index v = 0; v < nodes.cols(); ++v)
      u(0, v) = is_simplex(kind)
                  ? strain * nodes(0, v)
                  : strain * (std::clamp(nodes(0, v), 7. * B, 9. * B) - 7. * B);
    const double area      = B * (dim == 2 ? thickness : B);
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(dim, u.cols());
    forces.col(0)          = E * area * strain * axis;

    const auto delivered =
      delivered_constants(*mesh, element, axis, u, forces, thickness);
    ASSERT_TRUE(delivered);
    EXPECT_NEAR(delivered->youngs_modulus, E, 1e-9 * E);
    EXPECT_NEAR(delivered->poissons_ratio, nu, 1e-9);
  }
} // namespace

TEST(DeliveredConstants, OfASpecimenAreThoseOfItsStraightPart)
{
  for (const double way : {1., -1.})
    {
      const Eigen::Vector2d x2(way, 0.);
      pull_a_specimen<2>(CellKind::triangle, x2);
      pull_a_specimen<2>(CellKind::quadrilateral, x2);
      const Eigen::Vector3d x3(way, 0., 0.);
      pull_a_specimen<3>(CellKind::tetrahedron, x3);
      pull_a_specimen<3>(CellKind::hexahedron, x3);
    }
}

TEST(DeliveredConstants, AcrossASpecimenAreThoseOfTheMiddleThird)
{
  // Pulled along y, 0.01 m of 0.03 m lie in the middle: the gauge's width, so
  // that the area there is the length times the thickness.
  const auto mesh = build_mesh<2>(
    find_object("specimen")
      .describe({2, 2, CellKind::triangle, {0.16, 0.03}, {0.005}, "", 1.}));
  const auto element  = make_element<2>(mesh->cell_kind);
  const double strain = 0.01;
  Eigen::MatrixXd u   = Eigen::MatrixXd(strain * nodes_of(*mesh));
  u.row(0) *= -0.2;
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(2, u.cols());
  forces(1, 0)           = 1e4 * strain * 0.16 * 0.5;
  const auto delivered   = delivered_constants(
    *mesh, element, Eigen::Vector2d::UnitY(), u, forces, 0.5);
  EXPECT_NEAR(delivered->youngs_modulus, 1e4, 1e-5);
  EXPECT_NEAR(delivered->poissons_ratio, 0.2, 1e-9);
}

TEST(Loads, BalanceTheTractionOfOnePascal)
{
  oracle::Random random(6);
  const double L     = 0.03;
  const auto mesh    = oracle::box_mesh<3>(3, L, 0.2, random);
  const auto element = make_element<3>(mesh->cell_kind);
  const auto loads   = oracle::make_step<Loads<3>>(
    "subsection Loads\n set Cases = tension, compression, shear, torsion\n" +
    fixed_1_loaded_2);
  const auto loading =
    loads->resolve(*mesh, element, one_material<3>(1e4, 0.3, 1.));
  const auto nodes = nodes_of(*mesh);
  EXPECT_EQ(std::count(loading.held.begin(), loading.held.end(), true), 48);
  EXPECT_NEAR(loading.pull->extent, L, 1e-15);
  EXPECT_LT((loading.pull->axis - Eigen::Vector3d::UnitX()).norm(), 1e-12);

  const double F   = L * L;
  const auto total = [&](const int c) {
    return Eigen::Vector3d(loading.cases[c].load.forces.rowwise().sum());
  };
  EXPECT_LT((total(0) - Eigen::Vector3d(F, 0., 0.)).norm(), 1e-12 * F);
  EXPECT_LT((total(1) + total(0)).norm(), 1e-12 * F);
  EXPECT_LT((total(2) - Eigen::Vector3d(0., F, 0.)).norm(), 1e-12 * F);
  EXPECT_LT(total(3).norm(), 1e-12 * F);

  // The torque about x approximates that of r / r_max on a square by the
  // nodal rule, whose error for r^2 is known: h^2 / 6 per direction and unit
  // area.
  double torque = 0.;
  for (Eigen::Index v = 0; v < nodes.cols(); ++v)
    torque += (nodes(1, v) - L / 2.) * loading.cases[3].load.forces(2, v) -
              (nodes(2, v) - L / 2.) * loading.cases[3].load.forces(1, v);
  const double h     = L / 3.;
  const double exact = F * (L * L / 6. + h * h / 3.) / (L / std::sqrt(2.));
  EXPECT_NEAR(torque, exact, 1e-10 * exact);
}

TEST(Loads, RegionsSelectNodesAndFaces)
{
  oracle::Random random(7);
  const auto mesh    = oracle::box_mesh<2>(4, 1., 0., random);
  const auto element = make_element<2>(mesh->cell_kind);
  const auto loads =
    oracle::make_step<Loads<2>>("subsection Loads\n set Cases = shear\n"
                                " set Fixed region = y < 1e-6 and x < 0.51\n"
                                " set Loaded region = y > 0.999\nend");
  const auto loading =
    loads->resolve(*mesh, element, one_material<2>(1e4, 0.3, 0.1));
  EXPECT_EQ(std::count(loading.held.begin(), loading.held.end(), true), 6);
  EXPECT_LT((loading.pull->axis - Eigen::Vector2d::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(std::abs(loading.cases[0].load.forces.row(0).sum()), 0.1, 1e-12);
  EXPECT_NEAR(loading.cases[0].load.forces.row(1).norm(), 0., 1e-15);
}

TEST(Loads, RefuseWhatCannotStandOrIsNotLoaded)
{
  oracle::Random random(8);
  const auto mesh    = oracle::box_mesh<3>(2, 1., 0., random);
  const auto element = make_element<3>(mesh->cell_kind);
  const auto message = [&](const std::string &entries) -> std::string {
    const auto loads = oracle::make_step<Loads<3>>(
      "subsection Loads\n set Loaded boundaries = 2\n" + entries + "\nend");
    try
      {
        const auto loading =
          loads->resolve(*mesh, element, one_material<3>(1e4, 0.3, 1.));
        loads->check_supports(*mesh, loading);
        return "";
      }
    catch (const EntryError &error)
      {
        return error.what();
      }
  };
  const auto has = [](const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(message("set Fixed region = x < -1"), "no node"));
  EXPECT_TRUE(has(message("set Fixed region = x + y + z < 0.1"), "rotation"));
  EXPECT_TRUE(
    has(message("set Fixed region = x + y < 0.1"), "along (0, 0, 1)"));
  EXPECT_TRUE(has(message("set Fixed boundaries = 2"), "every loaded node"));
  EXPECT_TRUE(has(message("set Fixed boundaries = 3"), "3"));
  EXPECT_TRUE(
    has(message("set Fixed region = x << 1"), "cannot be understood"));
  EXPECT_EQ(message("set Fixed boundaries = 1"), "");
}
