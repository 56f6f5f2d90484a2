#include <springfit/response/loads.h>
#include <springfit/response/statics.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "meshes.h"
#include "nonlinear.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  /** A cube whose boundary 1 is x = 0 and 2 is x = side, under loads. */
  struct LoadedCube
  {
    static constexpr double side = 0.03;

    LoadedCube(const std::string &loads, const double nu, const double jitter)
      : mesh(box_mesh<3>(3, side, jitter, random))
      , element(make_element<3>(mesh->cell_kind))
      , nodes(nodes_of(*mesh))
      , materials({{0, solid_material(1e4, nu)}})
      , section(make_step<Loads<3>>("subsection Loads\n" + loads + "end"))
      , loading(section->resolve(*mesh, element, materials))
      , discretization(*mesh, loading.held, MPI_COMM_SELF)
    {
      section->check_supports(*mesh, loading);
    }

    Equilibrium
    respond(const std::string &law) const
    {
      return make_step<Statics<3>>("subsection Response\n set Material law = " +
                                   law + "\n set Tolerance = 1e-12\nend")
        ->finite_elements(discretization, *mesh, element, materials)
        ->respond(loading.cases.front().load);
    }

    Random random{31};
    std::unique_ptr<Mesh<3>> mesh;
    Element<3> element;
    Eigen::MatrixXd nodes;
    MaterialTable materials;
    std::unique_ptr<Loads<3>> section;
    Loading loading;
    Discretization<3> discretization;
  };

  /** Symmetry at x, y, z = 0, and the side x = 0.03 moved along x. */
  const std::string sliding =
    " set Fixed boundaries =\n"
    " set Supports = 1: x; where y < 1e-9: y; where z < 1e-9: z; 2: x = "
    "0.01 * t\n set Time = 0.3\n";

  Eigen::VectorXd
  force_of(const LoadedCube &cube,
           const Equilibrium &found,
           const std::string &support)
  {
    for (const auto &[name, force] :
         forces_of_supports(cube.loading, found.reactions))
      if (name == support)
        return force;
    return {};
  }

  constexpr double area = LoadedCube::side * LoadedCube::side;
} // namespace

TEST(OwnLoads, ATractionIsThatOfTension)
{
  const LoadedCube own(" set Tractions = pull on 2: 1, 0, 0\n", 0.3, 0.2);
  const LoadedCube canned(" set Loaded boundaries = 2\n set Cases = tension\n",
                          0.3,
                          0.2);
  EXPECT_EQ(own.loading.cases.front().name, "pull");
  const auto &expected = canned.loading.cases.front().load.forces;
  EXPECT_LT((own.loading.cases.front().load.forces - expected).norm(),
            1e-12 * expected.norm());
}

TEST(OwnLoads, ForcesAreThoseOfTheirSumAndPlace)
{
  const LoadedCube cube(
    " set Fixed boundaries = 1\n"
    " set Forces = press on 2: 0, -2 * t, 0; turn on where x > 0.0299: 0, -(z "
    "- 0.015), y - 0.015; press on 2: 1, 0, 0\n",
    0.3,
    0.);
  ASSERT_EQ(cube.loading.cases.size(), 2u);
  const auto press = cube.loading.cases[0].at(1.5);
  EXPECT_LT(
    (press.forces.rowwise().sum() - Eigen::Vector3d(1., -3., 0.)).norm(),
    1e-14);
  for (Eigen::Index v = 0; v < cube.nodes.cols(); ++v)
    if (cube.nodes(0, v) < 0.0299)
      EXPECT_EQ(press.forces.col(v).norm(), 0.);
  EXPECT_EQ(cube.loading.cases[1].name, "turn");
  EXPECT_LT(cube.loading.cases[1].load.forces.rowwise().sum().norm(), 1e-14);
}

TEST(OwnLoads, ABarUnderItsWeightIsExactAtTheNodes)
{
  // nu = 0: E u'' = - rho g, u(0) = 0, u'(L) = 0.
  const LoadedCube bar(" set Fixed boundaries = 1\n set Gravity = 9.81, 0, 0\n",
                       0.,
                       0.);
  const auto found         = bar.respond("linear");
  const double L           = LoadedCube::side;
  const double pull        = 1000. * 9.81 / 1e4;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3, bar.nodes.cols());
  expected.row(0)          = pull * (L * bar.nodes.row(0).array() -
                            0.5 * bar.nodes.row(0).array().square());
  EXPECT_LT((found.displacement - expected).norm(), 1e-10 * expected.norm());
  const double weight = 1000. * 9.81 * area * L;
  EXPECT_LT(
    (force_of(bar, found, "fixed") + Eigen::Vector3d(weight, 0., 0.)).norm(),
    1e-10 * weight);
}

TEST(OwnLoads, SlidingSupportsLeaveUniaxialStress)
{
  const double nu = 0.3, strain = 0.1;
  const LoadedCube cube(sliding, nu, 0.2);
  ASSERT_EQ(cube.loading.cases.front().name, "own");
  const auto found         = cube.respond("linear");
  Eigen::MatrixXd expected = -nu * strain * cube.nodes;
  expected.row(0)          = strain * cube.nodes.row(0);
  EXPECT_LT((found.displacement - expected).norm(), 1e-9 * expected.norm());
  const double F = 1e4 * strain * area;
  EXPECT_LT((force_of(cube, found, "2") - Eigen::Vector3d(F, 0., 0.)).norm(),
            1e-9 * F);
  EXPECT_LT((force_of(cube, found, "1") + Eigen::Vector3d(F, 0., 0.)).norm(),
            1e-9 * F);
  EXPECT_LT(force_of(cube, found, "all").norm(), 1e-9 * F);
}

TEST(OwnLoads, MovedSupportsStretchANeoHookeanBar)
{
  // nu = 0: P = mu (s - 1/s), s the stretch.
  const LoadedCube cube(sliding, 0., 0.2);
  const auto found = cube.respond("neo-hookean");
  ASSERT_EQ(found.failure, "");
  const double s = 1.1, F = 5e3 * (s - 1. / s) * area;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3, cube.nodes.cols());
  expected.row(0)          = (s - 1.) * cube.nodes.row(0);
  EXPECT_LT((found.displacement - expected).norm(), 1e-8 * expected.norm());
  EXPECT_LT((force_of(cube, found, "2") - Eigen::Vector3d(F, 0., 0.)).norm(),
            1e-8 * F);
}

TEST(OwnLoads, RefuseWhatCannotBeMeant)
{
  const auto message = [](const std::string &loads) -> std::string {
    try
      {
        LoadedCube(" set Loaded boundaries = 2\n" + loads, 0.3, 0.);
        return "";
      }
    catch (const EntryError &error)
      {
        return error.what();
      }
  };
  const auto expect = [&](const std::string &loads, const std::string &words) {
    EXPECT_NE(message(loads).find(words), std::string::npos) << message(loads);
  };
  expect(" set Supports = 1: x; where y < 1e-9: y\n",
         "the translation along (0, 0, 1)");
  expect(" set Supports = 1: x, y; 1: z; 2: x = 1e-3; where y < 1e-9: x\n",
         "is moved to");
  expect(" set Supports = 1: w\n", "'w' names no component");
  expect(" set Supports = 1: x, x = 3\n", "held twice");
  expect(" set Forces = 2: 1, 0\n", "2 components of a vector");
  expect(" set Forces = 2: 1, 0, 1 +\n", "cannot be understood");
  expect(" set Forces = 2: 1, 0, 1 / (x - x)\n", "no finite value");
  expect(" set Forces = where x > 1: 1, 0, 0\n", "no boundary face");
  expect(" set Forces = 7: 1, 0, 0\n", "7");
  expect(" set Forces = fem on 2: 1, 0, 0\n", "cannot be called 'fem'");
  expect(" set Forces = press on 2: 1, 0, 0\n set Cases = pres\n",
         "Did you mean 'press'?");
}
