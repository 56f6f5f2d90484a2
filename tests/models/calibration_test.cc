#include <springfit/calibration/calibration.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/reference/cell_energy.h>
#include <springfit/reference/cell_frame.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/springs/network.h>
#include <springfit/springs/volume.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "calibrated.h"

using namespace springfit;
using oracle::calibrated;
using oracle::number_of;
using oracle::tangent_at_rest;
using oracle::two_materials;

namespace
{
  /**
   * Rotated, mirrored, renumbered and scaled copies of a cell, far apart, of
   * two materials.
   */
  MeshDescription
  copies_of(const Eigen::MatrixXd &points,
            const CellKind kind,
            oracle::Random &random)
  {
    MeshDescription description;
    description.cell_kind = kind;
    int n_copies          = 0;
    for (const auto &symmetry : symmetries(kind))
      {
        // A mirror keeps the volume positive when the symmetry itself mirrors.
        Eigen::MatrixXd image(points.rows(), points.cols());
        for (int v = 0; v < points.cols(); ++v)
          image.col(v) = points.col(symmetry[v]);
        if (volume(image, kind) < 0.)
          image.row(0) *= -1.;
        const double scale = 1. + 0.1 * n_copies;
        image = scale * (random.rotation(points.rows()) * image).eval();
        for (int v = 0; v < points.cols(); ++v)
          {
            description.cells.push_back(description.vertices.size());
            MeshPoint point{};
            for (int d = 0; d < points.rows(); ++d)
              point[d] = image(d, v) + (d == 0 ? 20. * n_copies : 0.);
            description.vertices.push_back(point);
          }
        description.material_ids.push_back(n_copies % 2);
        ++n_copies;
      }
    return description;
  }

  /** The tangent of the finite elements in a deformed state. */
  template <int dim>
  Eigen::MatrixXd
  deformed_stiffness(const Mesh<dim> &mesh,
                     const MaterialTable &materials,
                     const MaterialLaw law,
                     const Eigen::MatrixXd &displacement)
  {
    const auto element = make_element<dim>(mesh.cell_kind);
    CellEnergy<dim> energy(element);
    Eigen::MatrixXd K =
      Eigen::MatrixXd::Zero(displacement.size(), displacement.size());
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        Eigen::MatrixXd u(dim, cell->n_vertices());
        for (const unsigned int v : cell->vertex_indices())
          u.col(v) = displacement.col(cell->vertex_index(v));
        const auto term =
          energy.evaluate(law, cell, materials.at(cell->material_id()), u);
        const auto &nodes = mesh.nodes.of(cell);
        for (std::size_t a = 0; a < nodes.size(); ++a)
          for (std::size_t b = 0; b < nodes.size(); ++b)
            K.block(dim * nodes[a], dim * nodes[b], dim, dim) +=
              term->hessian.block(dim * a, dim * b, dim, dim);
      }
    return K;
  }

  /** Every cell of the mesh has the tangent of its own fit in each network. */
  template <int dim>
  void
  expect_the_cells_own_fits(const Mesh<dim> &mesh,
                            const MaterialTable &materials,
                            const std::vector<CalibratedNetwork> &networks)
  {
    const auto element = make_element<dim>(mesh.cell_kind);
    CellMatrices<dim> matrices(element);
    for (const auto &network : networks)
      {
        const Eigen::MatrixXd K = tangent_at_rest(network.network);
        const Method &method =
          *value_of(method_words(), network.fit, "Fit/Methods");
        FitOptions options;
        options.enrichment =
          value_of(enrichment_words(), network.enrichment, "Fit/Enrichment");
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
          {
            const auto &material = materials.at(cell->material_id());
            const auto problem =
              make_fit_problem(cell_points<dim>(cell),
                               mesh.cell_kind,
                               matrices.stiffness(cell, material),
                               isotropic_material(dim,
                                                  material.lame.lambda,
                                                  material.lame.mu,
                                                  material.thickness));
            const Eigen::MatrixXd expected =
              problem.stiffness -
              residual(problem, fit(problem, method, options));
            const double size = expected.cwiseAbs().maxCoeff();
            for (const unsigned int v : cell->vertex_indices())
              for (const unsigned int w : cell->vertex_indices())
                EXPECT_LT((K.block(dim * cell->vertex_index(v),
                                   dim * cell->vertex_index(w),
                                   dim,
                                   dim) -
                           expected.block(dim * v, dim * w, dim, dim))
                            .cwiseAbs()
                            .maxCoeff(),
                          1e-9 * size);
          }
      }
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
  const auto mesh =
    build_mesh<3>(copies_of(points, CellKind::hexahedron, random));
  const auto materials = two_materials();
  EXPECT_EQ(find_distinct_cells(*mesh).distinct.size(), 2u);

  expect_the_cells_own_fits(*mesh, materials, calibrated(*mesh, materials));
}

TEST(Calibration, OfCongruentCellsWithCouplingsAndVolumesToo)
{
  oracle::Random random(5);
  const auto tetrahedra =
    build_mesh<3>(copies_of(oracle::random_cell(CellKind::tetrahedron, random),
                            CellKind::tetrahedron,
                            random));
  const auto of_tetrahedra =
    calibrated(*tetrahedra,
               two_materials(),
               " set Methods = lloyd, golec\n set Enrichment = none, volume\n");
  ASSERT_EQ(of_tetrahedra.size(), 2u);
  EXPECT_EQ(of_tetrahedra[0].name, "lloyd");
  EXPECT_EQ(of_tetrahedra[1].name, "golec_volume");
  EXPECT_EQ(of_tetrahedra[1].cells.size(), 2u);
  EXPECT_EQ(number_of("volumes", of_tetrahedra[1].network), 24u);
  expect_the_cells_own_fits(*tetrahedra, two_materials(), of_tetrahedra);

  for (const CellKind kind : {CellKind::triangle, CellKind::quadrilateral})
    {
      const auto plane = build_mesh<2>(
        copies_of(oracle::random_cell(kind, random), kind, random));
      const auto networks =
        calibrated(*plane,
                   two_materials(),
                   (kind == CellKind::triangle ? " set Methods = delingette\n"
                                               : " set Methods = baudet\n") +
                     std::string(" set Enrichment = coupling, none\n"));
      ASSERT_EQ(networks.size(), 2u);
      EXPECT_GT(number_of("couplings", networks[0].network), 0u);
      EXPECT_EQ(number_of("couplings", networks[1].network), 0u);
      expect_the_cells_own_fits(*plane, two_materials(), networks);
    }
}

TEST(Calibration, OfCongruentCellsWithAnglesToo)
{
  oracle::Random random(6);
  const std::string entries =
    " set Methods = frobenius, consistent\n set Enrichment = angles\n";
  for (const CellKind kind : {CellKind::triangle, CellKind::quadrilateral})
    {
      const auto mesh = build_mesh<2>(
        copies_of(oracle::random_cell(kind, random), kind, random));
      const auto networks = calibrated(*mesh, two_materials(), entries);
      ASSERT_EQ(networks.size(), 2u);
      EXPECT_EQ(number_of("angles", networks[0].network),
                mesh->triangulation.n_active_cells() * n_vertices(kind));
      expect_the_cells_own_fits(*mesh, two_materials(), networks);
    }

  const CellKind kind = CellKind::tetrahedron;
  const auto mesh =
    build_mesh<3>(copies_of(oracle::random_cell(kind, random), kind, random));
  const auto networks = calibrated(*mesh, two_materials(), entries);
  ASSERT_EQ(networks.size(), 2u);
  EXPECT_EQ(number_of("angles", networks[0].network),
            mesh->triangulation.n_active_cells() * 12);
  expect_the_cells_own_fits(*mesh, two_materials(), networks);
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

TEST(DistinctCells, OfARegularBoxAreOneInDirectionsToo)
{
  oracle::Random random(6);
  const auto regular = oracle::box_mesh<3>(3, 0.01, 0., random);
  EXPECT_EQ(find_distinct_oriented_cells(*regular).distinct.size(), 1u);
  const auto jittered = oracle::box_mesh<2>(5, 0.01, 0.2, random);
  EXPECT_EQ(find_distinct_oriented_cells(*jittered).distinct.size(), 25u);
}

TEST(DistinctCells, OfRotatedCopiesAreAllInDirections)
{
  oracle::Random random(7);
  const auto mesh =
    build_mesh<3>(copies_of(oracle::random_cell(CellKind::tetrahedron, random),
                            CellKind::tetrahedron,
                            random));
  EXPECT_EQ(find_distinct_cells(*mesh).distinct.size(), 2u);
  EXPECT_EQ(find_distinct_oriented_cells(*mesh).distinct.size(), 24u);
}

TEST(Calibration, OverStatesSuitsThem)
{
  // Moved and scaled copies of one cell: the network's tangent in the state is
  // nearer to that of the finite elements than without the state.
  oracle::Random random(8);
  const Eigen::MatrixXd points =
    oracle::random_cell(CellKind::tetrahedron, random);
  MeshDescription description;
  description.cell_kind = CellKind::tetrahedron;
  for (const double scale : {1., 0.5, 3.})
    {
      description.material_ids.push_back(0);
      for (int v = 0; v < 4; ++v)
        {
          description.cells.push_back(description.vertices.size());
          MeshPoint point{};
          for (int d = 0; d < 3; ++d)
            point[d] = scale * (points(d, v) + 10.);
          description.vertices.push_back(point);
        }
    }
  const auto mesh = build_mesh<3>(description);
  Eigen::MatrixXd u(3, 12);
  for (int v = 0; v < 12; ++v)
    u.col(v) << 0.3 * mesh->triangulation.get_vertices()[v][0], 0., 0.;

  // Springs alone gain 3 % only with the stable law, at least 12 % otherwise.
  using Bound = std::pair<MaterialLaw, double>;
  for (const auto &[material_law, bound] :
       {Bound(MaterialLaw::st_venant_kirchhoff, 0.9),
        Bound(MaterialLaw::neo_hookean, 0.9),
        Bound(MaterialLaw::stable_neo_hookean, 0.98)})
    {
      const MaterialLaw law = material_law; // for the lambda below
      const Eigen::MatrixXd R =
        deformed_stiffness(*mesh, two_materials(), law, u);
      for (const std::string enrichment : {"none", "volume", "coupling"})
        {
          const std::string entries = " set Methods = frobenius\n"
                                      " set Enrichment = " +
                                      enrichment + "\n";
          const auto error = [&](const std::string &states) {
            const auto networks =
              calibrated(*mesh, two_materials(), entries + states, law);
            EXPECT_EQ(networks[0].cells.size(), 1u);
            EXPECT_EQ(networks[0].cells[0].multiplicity, 3u);
            const auto &network = networks[0].network;
            return (R - Eigen::MatrixXd(
                          tangent(network.families, network.nodes + u)))
                     .norm() /
                   R.norm();
          };
          EXPECT_LT(error(" set States = stretch x 1.3\n"), bound * error(""));
        }
    }
}

TEST(Calibration, OverStatesOfStVenantKirchhoffIsExactWithCouplings)
{
  oracle::Random random(9);
  const auto check = [&](const auto &mesh) {
    const auto networks =
      calibrated(*mesh,
                 two_materials(),
                 " set Methods = frobenius\n set Enrichment = coupling\n"
                 " set Spring law = biquadratic\n"
                 " set States = stretch x 1.3, stretch y 0.8, shear yx 0.3\n",
                 MaterialLaw::st_venant_kirchhoff);
    for (const auto &cell : networks[0].cells)
      {
        EXPECT_LT(cell.result.states_residual.value(), 1e-12);
        EXPECT_LT(cell.result.frobenius_residual, 1e-12);
      }
  };
  check(
    build_mesh<3>(copies_of(oracle::random_cell(CellKind::tetrahedron, random),
                            CellKind::tetrahedron,
                            random)));
  check(build_mesh<2>(copies_of(oracle::random_cell(CellKind::triangle, random),
                                CellKind::triangle,
                                random)));
}
