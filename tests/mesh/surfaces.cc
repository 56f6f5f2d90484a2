// Triangles in space.

#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/build_mesh.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/materials.h>
#include <springfit/mesh/mesh_checks.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  MeshDescription
  triangles(const std::vector<MeshPoint> &vertices,
            const std::vector<unsigned int> &cells)
  {
    MeshDescription mesh;
    mesh.name         = "The surface";
    mesh.cell_kind    = CellKind::triangle;
    mesh.vertices     = vertices;
    mesh.cells        = cells;
    mesh.material_ids = std::vector<unsigned int>(mesh.n_cells(), 0);
    return mesh;
  }

  const std::vector<MeshPoint> corners = {{{0., 0., 0.}},
                                          {{1., 0., 0.}},
                                          {{0., 1., 1.}},
                                          {{1., 1., -1.}},
                                          {{0., -1., 2.}}};
} // namespace

TEST(VentricleFloor, has_the_published_counts)
{
  const auto mesh =
    make_mesh<2, 3>("Object = ventricle floor; Cells = triangles");
  EXPECT_EQ(mesh->triangulation.n_vertices(), 558u);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 1050u);
  EXPECT_EQ(mesh->triangulation.n_active_lines(), 1607u);
  const auto rim = boundary_table(*mesh);
  ASSERT_EQ(rim.size(), 1u);
  EXPECT_EQ(rim[0].name, "rim");
  EXPECT_EQ(rim[0].n_faces, 64u);
  // Ramanujan's perimeter of the ellipse.
  const double a = 0.01, b = 0.007, h = std::pow((a - b) / (a + b), 2.);
  const double perimeter =
    M_PI * (a + b) * (1. + 3. * h / (10. + std::sqrt(4. - 3. * h)));
  EXPECT_NEAR(rim[0].area, perimeter, 2e-3 * perimeter);
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    {
      double longest = 0.;
      for (const unsigned int l : cell->line_indices())
        longest = std::max(longest, cell->line(l)->diameter());
      // Of an equilateral triangle 0.43.
      EXPECT_GT(cell->measure() / (longest * longest), 0.15);
      for (const unsigned int v : cell->vertex_indices())
        {
          const auto &p    = cell->vertex(v);
          const double rho = std::hypot(p[0] / a, p[1] / b);
          EXPECT_NEAR(p[2], -0.003 * (1. - rho * rho), 1e-15);
        }
    }
}

TEST(VentricleFloor, is_of_triangles_in_space)
{
  expect_error([]() { make_mesh<3>("Object = ventricle floor"); },
               {"Geometry/Object", "Cells = triangles"});
  expect_error(
    []() { make_mesh<2>("Object = ventricle floor; Cells = triangles"); },
    {"Geometry/Object", "Dimension = 3"});
  expect_error(
    []() {
      make_mesh<2, 3>(
        "Object = ventricle floor; Cells = triangles; Size = 1, 1");
    },
    {"Geometry/Size", "depth"});
}

TEST(Sheet, is_a_box_of_triangles_in_space)
{
  const auto mesh = make_mesh<2, 3>(
    "Object = box; Cells = triangles; Size = 0.03, 0.02; Cell size = 0.005");
  EXPECT_NEAR(measure_of(*mesh), 6e-4, 1e-15);
  EXPECT_EQ(boundary_table(*mesh).size(), 4u);
  expect_error([]() { make_mesh<3>("Cells = quadrilaterals"); },
               {"Geometry/Cells", "made of triangles"});
  expect_error([]() { make_mesh<2, 3>("Cells = triangles; Jitter = 0.1"); },
               {"Geometry/Jitter"});
  expect_error(
    []() { make_mesh<2, 3>("Object = cylinder; Cells = triangles"); },
    {"Geometry/Cells", "a cylinder is no surface"});
}

TEST(SurfaceFile, of_every_format_is_read)
{
  const auto folder =
    std::filesystem::temp_directory_path() / "springfit_surface_formats";
  std::filesystem::create_directories(folder);
  const std::vector<std::string> formats = {
    "msh", "vtk", "unv", "mesh", "bdf", "inp"};
  double area = 0.;
  {
    // The mantle of a cylinder along z.
    const GmshSession session;
    gmsh::model::occ::addCylinder(0, 0, 0, 0, 0, 0.02, 0.01);
    gmsh::model::occ::remove({{3, 1}});
    gmsh::model::occ::remove({{2, 2}, {2, 3}});
    gmsh::model::occ::synchronize();
    set_gmsh_cell_size(0.004);
    gmsh::model::addPhysicalGroup(2, {1}, 5);
    gmsh::model::addPhysicalGroup(1, {1}, 17);
    gmsh::model::addPhysicalGroup(1, {3}, 19);
    mesh_gmsh_model("test", 2);
    for (const auto &format : formats)
      gmsh::write(folder / ("mantle." + format));
  }
  for (const auto &format : formats)
    {
      SCOPED_TRACE(format);
      const auto mesh = make_mesh<2, 3>(
        "Object = file; Cells = triangles; File = mantle." + format, folder);
      const double measure = measure_of(*mesh);
      EXPECT_NEAR(measure, 2. * M_PI * 0.01 * 0.02, 0.03 * measure);
      EXPECT_NEAR(measure, area == 0. ? measure : area, 1e-3 * measure);
      area           = measure;
      double of_rims = 0.;
      for (const auto &row : boundary_table(*mesh))
        of_rims += row.area;
      EXPECT_NEAR(of_rims, 4. * M_PI * 0.01, 0.03 * of_rims);
    }
  expect_error(
    [&]() { make_mesh<3>("Object = file; File = mantle.msh", folder); },
    {"no cells of dimension 3", "Cells = triangles", "Dimension = 2"});
  expect_error(
    [&]() { make_mesh<3>("Object = file; File = mantle.mesh", folder); },
    {"no cells of dimension 3", "Cells = triangles", "Dimension = 2"});
  std::filesystem::remove_all(folder);
}

TEST(SurfaceFile, of_a_body_is_none)
{
  expect_error(
    []() {
      make_mesh<2, 3>("Object = file; Cells = triangles; File = rod.geo",
                      MESH_DATA);
    },
    {"dimension 3", "Cells to tetrahedra"});
}

TEST(Surface, is_checked)
{
  // Neighbours need not agree on a side that is up.
  MeshDescription good =
    triangles({corners.begin(), corners.begin() + 4}, {0, 1, 2, 1, 2, 3});
  check_surface(good);
  const auto mesh = build_mesh<2, 3>(good);
  EXPECT_EQ(mesh->triangulation.n_active_lines(), 5u);

  expect_error(
    [&]() {
      MeshDescription branching =
        triangles(corners, {0, 1, 2, 0, 1, 3, 0, 1, 4});
      check_surface(branching);
    },
    {"3 cells share", "branches"});
  expect_error(
    [&]() {
      auto vertices = corners;
      vertices.pop_back();
      vertices[2]          = {{0.5, 0., 0.}};
      MeshDescription flat = triangles(vertices, {0, 1, 3, 0, 1, 2});
      check_surface(flat);
    },
    {"triangle 1", "has no area"});
}
