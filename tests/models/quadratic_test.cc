#include <springfit/comparison/interpolation.h>
#include <springfit/mesh/geometry.h>
#include <springfit/mesh/refine.h>
#include <springfit/reference/nodal_masses.h>
#include <springfit/reference/quadratic_nodes.h>
#include <springfit/response/loaded_surface.h>
#include <springfit/response/statics.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "meshes.h"

using namespace springfit;

namespace
{
  const std::vector<std::string> kinds_in_the_plane = {"triangles",
                                                       "quadrilaterals"},
                                 kinds_in_space = {"tetrahedra", "hexahedra"};

  template <int dim>
  const std::vector<std::string> &
  kinds()
  {
    return dim == 2 ? kinds_in_the_plane : kinds_in_space;
  }

  template <int dim>
  std::unique_ptr<Mesh<dim>>
  moved_box(const std::string &cells)
  {
    return oracle::make_step<Geometry<dim>>(
             "subsection Geometry\n set Object = box\n set Cells = " + cells +
             "\n set Size = 0.02, 0.03" + (dim == 3 ? ", 0.02" : "") +
             "\n set Cell size = 0.01\n set Jitter = 0.2\nend")
      ->create(MPI_COMM_SELF, "");
  }

  template <int dim>
  MaterialTable
  one_material(const double nu)
  {
    const ElasticConstants constants = {1e4, nu, 1000.};
    return {{0,
             {constants,
              dim == 2 ? lame_constants_plane_stress(constants)
                       : lame_constants(constants),
              1.}}};
  }

  /** A beam bent to the curvature 1 / m (Timoshenko and Goodier 1970, 102). */
  template <int dim>
  Eigen::MatrixXd
  bent(const std::vector<dealii::Point<dim>> &places, const double nu)
  {
    Eigen::MatrixXd u(dim, places.size());
    for (unsigned int v = 0; v < places.size(); ++v)
      {
        const auto &p  = places[v];
        const double z = dim == 3 ? p[dim - 1] : 0.;
        u(0, v)        = p[0] * p[1];
        u(1, v)        = -0.5 * (p[0] * p[0] + nu * p[1] * p[1] - nu * z * z);
        if (dim == 3)
          u(dim - 1, v) = -nu * p[1] * z;
      }
    return u;
  }

  template <int dim>
  void
  bend(const std::string &cells)
  {
    const double nu    = 0.4;
    auto mesh          = moved_box<dim>(cells);
    mesh->nodes        = quadratic_nodes(*mesh);
    const auto element = make_element<dim>(mesh->cell_kind, mesh->nodes.degree);
    const auto expected = bent<dim>(mesh->nodes.places, nu);

    // Bent at all sides, free inside.
    std::vector<bool> outside(mesh->nodes.size(), false);
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          for (const unsigned int a : mesh->nodes.of_faces[f])
            outside[mesh->nodes.of(cell)[a]] = true;
    NodalLoad load{Eigen::MatrixXd::Zero(dim, mesh->nodes.size()), expected};
    unsigned int n_free = 0;
    for (unsigned int v = 0; v < mesh->nodes.size(); ++v)
      if (!outside[v])
        {
          load.support.col(v).setZero();
          ++n_free;
        }
    EXPECT_GT(n_free, 0u);

    const Discretization<dim> discretization(*mesh,
                                             oracle::unknowns_of(dim, outside),
                                             MPI_COMM_SELF);
    const auto statics = oracle::make_step<Statics<dim>>("");
    const auto u =
      statics
        ->finite_elements(discretization, *mesh, element, one_material<dim>(nu))
        ->respond(load)
        .displacement;
    EXPECT_LT((u - expected).norm(), 1e-10 * expected.norm()) << cells;
  }

  template <int dim>
  void
  interpolate_at_random(const std::string &cells)
  {
    oracle::Random random(3);
    auto mesh = moved_box<dim>(cells);
    std::vector<dealii::Point<dim>> points(50);
    for (auto &point : points)
      for (int d = 0; d < dim; ++d)
        point[d] = random(0., d == 1 ? 0.03 : 0.02);

    const auto linear =
      interpolation(*mesh, make_element<dim>(mesh->cell_kind), points);
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        EXPECT_LT(linear.distances[p], 1e-12);
        dealii::Point<dim> place;
        for (Eigen::SparseMatrix<double>::InnerIterator w(linear.weights, p); w;
             ++w)
          place += w.value() * mesh->nodes.places[w.row()];
        EXPECT_LT(place.distance(points[p]), 1e-12) << cells;
      }

    mesh->nodes = quadratic_nodes(*mesh);
    const auto quadratic =
      interpolation(*mesh, make_element<dim>(mesh->cell_kind, 2), points);
    EXPECT_LT((bent<dim>(mesh->nodes.places, 0.3) * quadratic.weights -
               bent<dim>(points, 0.3))
                .norm(),
              1e-14)
      << cells;
  }

  template <int dim>
  void
  share_masses_and_tractions(const std::string &cells)
  {
    auto mesh          = moved_box<dim>(cells);
    mesh->nodes        = quadratic_nodes(*mesh);
    const auto element = make_element<dim>(mesh->cell_kind, 2);
    const auto masses  = nodal_masses(*mesh, element, one_material<dim>(0.));
    // Boxes have their sides at x = 0 and x = 0.02 among others.
    std::vector<typename LoadedSurface<dim>::Face> faces;
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->center()[0] > 0.02 - 1e-9)
          faces.push_back({cell, f});
    const auto shares =
      LoadedSurface<dim>(*mesh, std::move(faces), element).shares();

    // The centre of the sides' forces is theirs, as Simpson's rule has it.
    double mass = 0., area = 0., moment = 0.;
    for (unsigned int v = 0; v < mesh->nodes.size(); ++v)
      {
        mass += masses[v];
        area += shares[v];
        moment += shares[v] * mesh->nodes.places[v][1];
        if (mesh->nodes.places[v][0] < 0.02 - 1e-9)
          {
            EXPECT_EQ(shares[v], 0.);
          }
      }
    const double depth = dim == 3 ? 0.02 : 1.;
    EXPECT_NEAR(mass, 1000. * 0.02 * 0.03 * depth, 1e-12 * mass);
    EXPECT_NEAR(area, 0.03 * depth, 1e-12 * area);
    EXPECT_NEAR(moment, 0.015 * area, 1e-12 * area);
  }

  template <int dim>
  void
  refine_a_box(const std::string &cells)
  {
    auto mesh          = moved_box<dim>(cells);
    const auto n_cells = mesh->triangulation.n_active_cells();
    const auto element = make_element<dim>(mesh->cell_kind);
    const double mass =
      nodal_masses(*mesh, element, one_material<dim>(0.)).sum();
    const auto before = mesh->nodes.places;
    refine(*mesh);
    EXPECT_EQ(mesh->triangulation.n_active_cells(), n_cells << dim);
    EXPECT_NEAR(nodal_masses(*mesh, element, one_material<dim>(0.)).sum(),
                mass,
                1e-12 * mass);
    for (unsigned int v = 0; v < before.size(); ++v)
      EXPECT_EQ(mesh->nodes.places[v], before[v]);
  }
} // namespace

TEST(Quadratic, BendsExactly)
{
  for (const auto &cells : kinds<2>())
    bend<2>(cells);
  for (const auto &cells : kinds<3>())
    bend<3>(cells);
}

TEST(Quadratic, SharesMassesAndTractions)
{
  for (const auto &cells : kinds<2>())
    share_masses_and_tractions<2>(cells);
  for (const auto &cells : kinds<3>())
    share_masses_and_tractions<3>(cells);
}

TEST(Interpolation, IsExactForTheElementsFunctions)
{
  for (const auto &cells : kinds<2>())
    interpolate_at_random<2>(cells);
  for (const auto &cells : kinds<3>())
    interpolate_at_random<3>(cells);
}

TEST(Interpolation, GoesOnOutside)
{
  const auto mesh  = moved_box<3>("tetrahedra");
  const auto there = interpolation(*mesh,
                                   make_element<3>(mesh->cell_kind),
                                   {dealii::Point<3>(0.021, 0.01, 0.012)});
  EXPECT_GT(there.distances[0], 0.001 - 1e-12);
  EXPECT_LT(there.distances[0], 0.0015);
  EXPECT_LT((oracle::nodes_of(*mesh) * there.weights -
             Eigen::Vector3d(0.021, 0.01, 0.012))
              .norm(),
            1e-12);
}

TEST(Refinement, KeepsTheBodyAndItsNodes)
{
  for (const auto &cells : kinds<2>())
    refine_a_box<2>(cells);
  for (const auto &cells : kinds<3>())
    refine_a_box<3>(cells);
}
