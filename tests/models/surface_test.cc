// Surfaces in space: membranes of triangles, against the plane, against the
// differences of their energies, and their springs against them.

#include <springfit/reference/membrane_state.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/response/network_body.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "calibrated.h"
#include "nonlinear.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  using Plane = Eigen::Matrix2d;
  using Tall  = Eigen::Matrix<double, 3, 2>;

  std::vector<PlaneLaw>
  plane_laws()
  {
    const auto lame = sheet_material(2., 0.3).lame;
    return {[lame](const Plane &F) { return st_venant_kirchhoff<2>(F, lame); },
            [lame](const Plane &F) {
              return neo_hookean_plane_stress(F, lame);
            },
            [lame](const Plane &F) { return stable_neo_hookean<2>(F, lame); }};
  }

  /** 4 x 4 squares of two triangles each, their inner vertices moved. */
  MeshDescription
  sheet(Random &random)
  {
    constexpr unsigned int n = 4;
    MeshDescription mesh;
    mesh.cell_kind = CellKind::triangle;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        {
          const bool inner   = i > 0 && i < n && j > 0 && j < n;
          const double moved = inner ? 0.2 : 0.;
          mesh.vertices.push_back({{0.01 * (i + random(-moved, moved)),
                                    0.01 * (j + random(-moved, moved)),
                                    0.}});
        }
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int v = i + (n + 1) * j;
          mesh.cells.insert(mesh.cells.end(),
                            {v, v + 1, v + n + 2, v, v + n + 2, v + n + 1});
        }
    mesh.material_ids.assign(mesh.n_cells(), 0);
    return mesh;
  }

  /** The sheet rolled and bulged. */
  MeshDescription
  bulged_sheet(Random &random)
  {
    MeshDescription mesh = sheet(random);
    for (auto &[x, y, z] : mesh.vertices)
      z = 0.3 * x + 20. * x * y - 8. * y * y;
    return mesh;
  }

  const MaterialTable sheets = {{0, sheet_material(1e4, 0.4)}};

  FiniteElementBody<2, 3>
  membrane(const Mesh<2, 3> &mesh,
           const Element<2, 3> &element,
           const MaterialLaw law)
  {
    return {mesh, element, sheets, law};
  }
} // namespace

TEST(Membranes, HaveTheStressAndTangentOfTheirEnergy)
{
  Random random(31);
  for (const auto &law : plane_laws())
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        const Tall F   = Tall::Identity() + random_matrix(3, 2, 0.4, random);
        const Tall dF  = random_matrix(3, 2, 1., random);
        const double h = 1e-5;
        const auto at  = [&](const double t) {
          return *membrane_state(law, F + t * dF);
        };
        const auto state = at(0.), plus = at(h), minus = at(-h);
        EXPECT_NEAR((plus.energy - minus.energy) / (2. * h),
                    state.stress.cwiseProduct(dF).sum(),
                    1e-8);
        const Tall dP = (plus.stress - minus.stress) / (2. * h);
        EXPECT_LT((dP.reshaped() - state.tangent * dF.reshaped()).norm(), 1e-7);
        EXPECT_LT((state.tangent - state.tangent.transpose()).norm(),
                  1e-12 * state.tangent.norm());
      }
}

TEST(Membranes, AreTheLawOfThePlaneWhereverTheyTurn)
{
  Random random(32);
  const Eigen::Matrix3d R = rotation<3>();
  for (const auto &law : plane_laws())
    {
      const Plane F = Plane::Identity() + random_matrix(2, 2, 0.3, random);
      Tall in_plane = Tall::Zero();
      in_plane.topRows<2>() = F;
      const auto plane      = *law(F);
      const auto state      = *membrane_state(law, in_plane);
      EXPECT_NEAR(state.energy, plane.energy, 1e-14);
      EXPECT_LT((state.stress.topRows<2>() - plane.stress).norm(), 1e-14);
      EXPECT_LT(state.stress.row(2).norm(), 1e-14);
      const auto turned = *membrane_state(law, R * in_plane);
      EXPECT_NEAR(turned.energy, plane.energy, 1e-14);
      EXPECT_LT((turned.stress - R * state.stress).norm(), 1e-13);
    }
  // Of rank one.
  EXPECT_FALSE(
    membrane_state(plane_laws()[0],
                   Eigen::Vector3d(1., 2., 3.) * Eigen::RowVector2d(1., 0.5)));
}

TEST(Surfaces, InThePlaneAreThePlanesFiniteElements)
{
  Random random(33);
  const auto description   = sheet(random);
  const auto plane         = build_mesh<2>(description);
  const auto space         = build_mesh<2, 3>(description);
  const auto of_plane      = make_element<2>(CellKind::triangle);
  const auto of_space      = make_element<2, 3>(CellKind::triangle);
  const Eigen::Index n     = nodes_of(*plane).cols();
  const Eigen::MatrixXd u2 = random_matrix(2, n, 1e-3, random);
  Eigen::MatrixXd u3       = Eigen::MatrixXd::Zero(3, n);
  u3.topRows(2)            = u2;
  for (const auto law : {MaterialLaw::linear,
                         MaterialLaw::st_venant_kirchhoff,
                         MaterialLaw::neo_hookean,
                         MaterialLaw::stable_neo_hookean})
    {
      const auto a =
        evaluate(FiniteElementBody<2>(*plane, of_plane, sheets, law), u2);
      const auto b = evaluate(membrane(*space, of_space, law), u3);
      EXPECT_NEAR(b.energy, a.energy, 1e-12 * a.energy);
      EXPECT_LT((b.forces.topRows(2) - a.forces).norm(),
                1e-12 * a.forces.norm());
      EXPECT_LT(b.forces.row(2).norm(), 1e-12 * a.forces.norm());
    }
}

TEST(Surfaces, AreConsistentAndRigid)
{
  Random random(34);
  const auto mesh    = build_mesh<2, 3>(bulged_sheet(random));
  const auto element = make_element<2, 3>(CellKind::triangle);
  const auto nodes   = nodes_of(*mesh);
  for (const auto law : hyperelastic)
    {
      const auto body = membrane(*mesh, element, law);
      check_derivatives(body,
                        random_matrix(3, nodes.cols(), 1e-3, random),
                        0.01,
                        random);
      check_shares(body, random_matrix(3, nodes.cols(), 1e-3, random), random);
      check_rigid_rotation<3>(body, nodes, random);
    }
  const auto masses = nodal_masses(*mesh, element, sheets);
  double area       = 0.;
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    area += cell->measure();
  EXPECT_NEAR(masses.sum(), 1000. * 0.5 * area, 1e-12);
}

TEST(Surfaces, WithCouplingsHaveTheTangentOfTheFiniteElements)
{
  Random random(35);
  const auto mesh            = build_mesh<2, 3>(bulged_sheet(random));
  const auto element         = make_element<2, 3>(CellKind::triangle);
  const Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(3, nodes_of(*mesh).cols());
  const auto expected =
    evaluate(membrane(*mesh, element, MaterialLaw::linear), rest).tangent;
  const auto network = calibrated(*mesh,
                                  sheets,
                                  " set Methods = frobenius\n"
                                  " set Enrichment = coupling\n")[0]
                         .network;
  EXPECT_LT((evaluate(NetworkBody(network), rest).tangent - expected).norm(),
            1e-12 * expected.norm());
}

TEST(Surfaces, HaveExactSpringsAtLargeDeformations)
{
  struct Exact
  {
    MaterialLaw law;
    std::string entries;
  };
  const std::vector<Exact> all = {
    {MaterialLaw::st_venant_kirchhoff,
     " set Methods = frobenius\n set Enrichment = coupling\n"
     " set Spring law = biquadratic\n"},
    {MaterialLaw::stable_neo_hookean,
     " set Methods = stable neo-hookean\n set Enrichment = volume\n"},
    {MaterialLaw::neo_hookean,
     " set Methods = stable neo-hookean\n set Enrichment = volume\n"
     " set Volume law = logarithmic\n"}};
  Random random(36);
  const auto mesh    = build_mesh<2, 3>(bulged_sheet(random));
  const auto element = make_element<2, 3>(CellKind::triangle);
  const auto nodes   = nodes_of(*mesh);
  for (const auto &[law, entries] : all)
    {
      const auto body = membrane(*mesh, element, law);
      const NetworkBody springs(
        calibrated(*mesh, sheets, entries, law)[0].network);
      const Eigen::MatrixXd u = random_matrix(3, nodes.cols(), 2e-3, random);
      const auto expected     = evaluate(body, u);
      const auto found        = evaluate(springs, u);
      EXPECT_LT((found.forces - expected.forces).norm(),
                1e-10 * expected.forces.norm());
      EXPECT_LT((found.tangent - expected.tangent).norm(),
                1e-10 * expected.tangent.norm());
    }
}

TEST(Surfaces, AreFittedCellByCellAtRest)
{
  Random random(37);
  const auto mesh = build_mesh<2, 3>(bulged_sheet(random));
  EXPECT_THROW(calibrated(*mesh, sheets, " set Scope = object\n"), EntryError);
  EXPECT_THROW(calibrated(*mesh,
                          sheets,
                          " set States = stretch x 1.3\n",
                          MaterialLaw::neo_hookean),
               EntryError);
}
