#include <springfit/reference/cell_frame.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/reference/material.h>

#include <gtest/gtest.h>

#include "meshes.h"

using namespace springfit;

namespace
{
  CellMaterial
  cell_material(const double E, const double nu, const bool plane_stress)
  {
    const ElasticConstants constants = {E, nu, 1200.};
    return {constants,
            plane_stress ? lame_constants_plane_stress(constants)
                         : lame_constants(constants),
            plane_stress ? 0.3 : 1.};
  }

  template <int dim>
  void
  compare_stiffness(const CellKind kind,
                    const bool plane_stress,
                    const Eigen::MatrixXd &D,
                    oracle::Random &random)
  {
    const double nu = 0.3, E = 5e3;
    for (int repetition = 0; repetition < 10; ++repetition)
      {
        const Eigen::MatrixXd points = 0.01 * oracle::random_cell(kind, random);
        const auto mesh    = oracle::single_cell_mesh<dim>(kind, points);
        const auto element = make_element<dim>(kind);
        CellMatrices<dim> matrices(element);
        const auto cell     = mesh->triangulation.begin_active();
        const auto material = cell_material(E, nu, plane_stress);

        const Eigen::MatrixXd expected =
          E * material.thickness * oracle::stiffness(points, kind, D);
        // deal.II may number the vertices of a cell in its own way.
        Eigen::MatrixXd permuted(expected.rows(), expected.cols());
        for (const unsigned int a : cell->vertex_indices())
          for (const unsigned int b : cell->vertex_indices())
            permuted.block(dim * a, dim * b, dim, dim) =
              expected.block(dim * cell->vertex_index(a),
                             dim * cell->vertex_index(b),
                             dim,
                             dim);
        EXPECT_LT((matrices.stiffness(cell, material) - permuted).norm(),
                  1e-12 * expected.norm())
          << singular(kind);
      }
  }
} // namespace

TEST(Stiffness, AgreesWithIndependentIntegration)
{
  oracle::Random random(1);
  for (const CellKind kind : {CellKind::triangle, CellKind::quadrilateral})
    {
      compare_stiffness<2>(kind, true, oracle::plane_stress(0.3), random);
      compare_stiffness<2>(kind, false, oracle::plane_strain(0.3), random);
    }
  for (const CellKind kind : {CellKind::tetrahedron, CellKind::hexahedron})
    compare_stiffness<3>(kind, false, oracle::solid(0.3), random);
}

TEST(IntegratedGradients, DoTheWorkOfAUniformStress)
{
  oracle::Random random(6);
  for (const CellKind kind : {CellKind::tetrahedron, CellKind::hexahedron})
    {
      const Eigen::MatrixXd points = oracle::random_cell(kind, random);
      const auto mesh              = oracle::single_cell_mesh<3>(kind, points);
      const auto element           = make_element<3>(kind);
      CellMatrices<3> matrices(element);
      const auto cell              = mesh->triangulation.begin_active();
      const Eigen::MatrixXd x      = cell_points<3>(cell);
      const Eigen::MatrixXd stress = oracle::isotropic(3, 1., 0.); // pressure
      const Eigen::VectorXd forces =
        oracle::stiffness(x, kind, stress) * x.reshaped() / 3.;
      EXPECT_LT(
        (matrices.integrated_gradients(cell).reshaped() - forces).norm(),
        1e-12 * forces.norm());
    }
}

TEST(Masses, SumToTheMassOfEveryCell)
{
  oracle::Random random(2);
  for (int repetition = 0; repetition < 20; ++repetition)
    {
      const auto points   = oracle::random_cell(CellKind::hexahedron, random);
      const auto material = cell_material(1., 0.3, false);
      const auto mesh =
        oracle::single_cell_mesh<3>(CellKind::hexahedron, points);
      const auto element = make_element<3>(CellKind::hexahedron);
      CellMatrices<3> matrices(element);
      const auto cell   = mesh->triangulation.begin_active();
      const auto masses = matrices.masses(cell, material);
      EXPECT_NEAR(masses.sum(), 1200. * cell->measure(), 1e-9);
      EXPECT_GT(masses.minCoeff(), 0.);
    }
}

TEST(Masses, AreEqualSharesOfASimplexAndOfABox)
{
  const auto material = cell_material(1., 0.3, true);
  for (const CellKind kind : {CellKind::triangle, CellKind::quadrilateral})
    {
      const auto points  = oracle::regular_cell(kind);
      const auto mesh    = oracle::single_cell_mesh<2>(kind, points);
      const auto element = make_element<2>(kind);
      CellMatrices<2> matrices(element);
      const auto cell    = mesh->triangulation.begin_active();
      const double share = 1200. * 0.3 * cell->measure() / points.cols();
      EXPECT_LT(
        (matrices.masses(cell, material).array() - share).abs().maxCoeff(),
        1e-12 * share);
    }
}

TEST(Material, GivesEachMaterialIdItsConstants)
{
  oracle::Random random(3);
  const auto mesh = oracle::box_mesh<2>(2, 1., 0., random);
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    cell->set_material_id(cell->active_cell_index() < 2 ? 4 : 7);
  mesh->material_names.emplace(7, "stiff");

  const auto material =
    oracle::make_step<Material<2>>("subsection Material\n"
                                   " set Young's modulus = 4: 1e3, stiff: 2e5\n"
                                   " set Poisson's ratio = 0.5\n"
                                   " set Thickness = 0.02\n"
                                   "end");
  const auto table = material->resolve(*mesh);
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.at(4).constants.youngs_modulus, 1e3);
  EXPECT_EQ(table.at(7).constants.youngs_modulus, 2e5);
  EXPECT_EQ(table.at(7).constants.poissons_ratio, 0.5);
  EXPECT_EQ(table.at(7).thickness, 0.02);

  const auto incomplete = oracle::make_step<Material<2>>(
    "subsection Material\n set Young's modulus = 4: 1e3\nend");
  EXPECT_THROW(incomplete->resolve(*mesh), EntryError);
}

TEST(Material, RefusesWhatIsOutOfRange)
{
  for (const std::string entry : {"Young's modulus = -1",
                                  "Young's modulus = nan",
                                  "Poisson's ratio = -1",
                                  "Poisson's ratio = 0.5001",
                                  "Density = 0",
                                  "Thickness = 0",
                                  "Plane state = stres"})
    EXPECT_THROW(oracle::make_step<Material<2>>("subsection Material\n set " +
                                                entry + "\nend"),
                 EntryError)
      << entry;
  EXPECT_THROW(oracle::make_step<Material<3>>(
                 "subsection Material\n set Poisson's ratio = 0.5\nend"),
               EntryError);
  EXPECT_THROW(oracle::make_step<Material<2>>(
                 "subsection Material\n set Poisson's ratio = 0.5\n set Plane "
                 "state = strain\nend"),
               EntryError);
}
