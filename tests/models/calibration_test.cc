#include <springfit/calibration/calibration.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/reference/cell_matrices.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "meshes.h"

using namespace springfit;

namespace
{
  MaterialTable
  two_materials()
  {
    const ElasticConstants soft = {1e4, 0.3, 1000.}, stiff = {3e4, 0.2, 2000.};
    return {{0, {soft, lame_constants(soft), 1.}},
            {1, {stiff, lame_constants(stiff), 1.}}};
  }

  template <int dim>
  std::vector<CalibratedNetwork>
  calibrated(const Mesh<dim> &mesh, const MaterialTable &materials)
  {
    const auto folder =
      std::filesystem::temp_directory_path() / "springfit_calibration_test";
    Session session(MPI_COMM_SELF, folder);
    const auto calibration = oracle::make_step<Calibration<dim>>(
      "subsection Fit\n set Methods = block, frobenius\nend");
    auto networks = calibration->calibrate(mesh,
                                           make_element<dim>(mesh.cell_kind),
                                           materials,
                                           session);
    std::filesystem::remove_all(folder);
    return networks;
  }
} // namespace

TEST(DistinctCells, OfARegularBoxIsOneForEachMaterial)
{
  oracle::Random random(1);
  const auto mesh = oracle::box_mesh<3>(4, 0.01, 0., random);
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    cell->set_material_id(cell->center()[1] > 0.0074);
  const auto cells = find_distinct_cells(*mesh);
  ASSERT_EQ(cells.distinct.size(), 2u);
  EXPECT_EQ(cells.distinct[0].multiplicity, 48u);
  EXPECT_EQ(cells.distinct[1].multiplicity, 16u);
}

TEST(DistinctCells, OfAJitteredBoxAreAll)
{
  oracle::Random random(2);
  const auto mesh = oracle::box_mesh<2>(5, 0.01, 0.2, random);
  EXPECT_EQ(find_distinct_cells(*mesh).distinct.size(), 25u);
}

TEST(Calibration, OfCongruentCellsEqualsFittingEachOne)
{
  // Mirrored, renumbered and scaled copies of one irregular cell, glued by
  // nothing: the network must be the fits of the single cells.
  oracle::Random random(3);
  const Eigen::MatrixXd points =
    oracle::random_cell(CellKind::hexahedron, random);
  MeshDescription description;
  std::vector<Eigen::MatrixXd> cells;
  description.cell_kind = CellKind::hexahedron;
  int n_copies          = 0;
  for (const auto &symmetry : symmetries(CellKind::hexahedron))
    {
      // The images of one symmetry; a mirror keeps the volume positive when
      // the symmetry itself mirrors.
      Eigen::MatrixXd image(3, 8);
      for (int v = 0; v < 8; ++v)
        image.col(v) = points.col(symmetry[v]);
      Eigen::Matrix3d edges;
      edges << image.col(1) - image.col(0), image.col(2) - image.col(0),
        image.col(4) - image.col(0);
      if (edges.determinant() < 0.)
        image.row(0) *= -1.;
      const double scale = 1. + 0.1 * n_copies;
      image              = scale * (random.rotation(3) * image).eval();
      for (int v = 0; v < 8; ++v)
        {
          description.cells.push_back(description.vertices.size());
          description.vertices.push_back(
            {{image(0, v) + 20. * n_copies, image(1, v), image(2, v)}});
        }
      description.material_ids.push_back(n_copies % 2);
      ++n_copies;
    }
  const auto mesh      = build_mesh<3>(description);
  const auto materials = two_materials();
  EXPECT_EQ(find_distinct_cells(*mesh).distinct.size(), 2u);

  const auto networks = calibrated(*mesh, materials);
  const auto element  = make_element<3>(CellKind::hexahedron);
  CellMatrices<3> matrices(element);
  for (const auto &network : networks)
    {
      std::map<std::pair<unsigned int, unsigned int>, double> stiffness;
      for (std::size_t s = 0; s < network.network.stiffness.size(); ++s)
        stiffness[{network.network.i[s], network.network.j[s]}] =
          network.network.stiffness[s];
      for (const auto &cell : mesh->triangulation.active_cell_iterators())
        {
          const auto problem = make_fit_problem(
            cell_points<3>(cell),
            CellKind::hexahedron,
            matrices.stiffness(cell, materials.at(cell->material_id())),
            {});
          const auto result =
            fit(problem,
                value_of(method_words(), network.fit, "Fit/Methods"),
                FitOptions());
          const double size = result.k.cwiseAbs().maxCoeff();
          for (std::size_t s = 0; s < problem.springs.size(); ++s)
            {
              const auto a = cell->vertex_index(problem.springs[s][0]);
              const auto b = cell->vertex_index(problem.springs[s][1]);
              EXPECT_NEAR((stiffness[{std::min(a, b), std::max(a, b)}]),
                          result.k[s],
                          1e-9 * size);
            }
        }
    }
}

TEST(Calibration, MassesSumToThoseOfTheBody)
{
  oracle::Random random(4);
  const auto mesh = oracle::box_mesh<3>(3, 0.1, 0.2, random);
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    cell->set_material_id(cell->active_cell_index() % 2);
  double expected = 0.;
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    expected += cell->measure() * (cell->material_id() == 0 ? 1000. : 2000.);
  const auto networks = calibrated(*mesh, two_materials());
  double total        = 0.;
  for (const double mass : networks.front().network.mass)
    total += mass;
  EXPECT_NEAR(total, expected, 1e-12 * expected);
}
