// Boxes and cylinders, from the parameters to deal.II's triangulation.

#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/build_mesh.h>
#include <springfit/mesh/cell_orientation.h>
#include <springfit/mesh/materials.h>

#include <deal.II/grid/tria.h>

#include <cmath>

#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  template <int dim>
  void
  expect_box(const Mesh<dim> &mesh, const std::vector<double> &size)
  {
    double measure = 1.;
    for (const double length : size)
      measure *= length;
    EXPECT_NEAR(measure_of(mesh), measure, 1e-12 * measure);

    const std::vector<std::string> names = {
      "x min", "x max", "y min", "y max", "z min", "z max"};
    const auto table = boundary_table(mesh);
    ASSERT_EQ(table.size(), 2u * dim);
    for (unsigned int i = 0; i < table.size(); ++i)
      {
        EXPECT_EQ(table[i].id, i);
        EXPECT_EQ(table[i].name, names[i]);
        const double area = measure / size[i / 2];
        EXPECT_NEAR(table[i].area, area, 1e-12 * area);
      }
    EXPECT_TRUE(mesh.warnings.empty());
    EXPECT_EQ(material_table(mesh).size(), 1u);
  }

  template <int dim>
  void
  expect_counts(const Mesh<dim> &mesh,
                const unsigned int n_vertices,
                const unsigned int n_cells)
  {
    EXPECT_EQ(mesh.triangulation.n_vertices(), n_vertices);
    EXPECT_EQ(mesh.triangulation.n_used_vertices(), n_vertices);
    EXPECT_EQ(mesh.triangulation.n_active_cells(), n_cells);
  }
} // namespace


TEST(Box, of_quadrilaterals)
{
  const auto mesh = make_mesh<2>("Size = 0.03, 0.02; Cell size = 0.005");
  EXPECT_EQ(mesh->cell_kind, CellKind::quadrilateral);
  expect_counts(*mesh, 7 * 5, 6 * 4);
  expect_box(*mesh, {0.03, 0.02});
}

TEST(Box, of_triangles)
{
  const auto mesh = make_mesh<2>("Cells = triangles; Cell size = 0.0025");
  EXPECT_TRUE(mesh->triangulation.all_reference_cells_are_simplex());
  expect_box(*mesh, {0.02, 0.02});
  EXPECT_NEAR(mesh->triangulation.n_vertices(), 101, 10);
  EXPECT_NEAR(mesh->triangulation.n_active_cells(), 168, 20);
}

TEST(Box, of_hexahedra)
{
  const auto mesh = make_mesh<3>("Size = 0.03, 0.02, 0.01; Cell size = 0.005");
  EXPECT_EQ(mesh->cell_kind, CellKind::hexahedron);
  expect_counts(*mesh, 7 * 5 * 3, 6 * 4 * 2);
  expect_box(*mesh, {0.03, 0.02, 0.01});
}

TEST(Box, of_the_defaults_is_the_cube_of_512_cells)
{
  const auto mesh = make_mesh<3>("Object = box");
  expect_counts(*mesh, 729, 512);
  expect_box(*mesh, {0.02, 0.02, 0.02});
}

TEST(Box, with_a_cell_size_for_each_direction)
{
  const auto mesh = make_mesh<3>("Cell size = 0.02, 0.01, 0.004");
  expect_counts(*mesh, 2 * 3 * 6, 1 * 2 * 5);
}

TEST(Box, of_tetrahedra)
{
  const auto mesh = make_mesh<3>("Cells = tetrahedra; Cell size = 0.005; "
                                 "Size = 0.02, 0.03, 0.01");
  EXPECT_TRUE(mesh->triangulation.all_reference_cells_are_simplex());
  expect_box(*mesh, {0.02, 0.03, 0.01});
}

TEST(Box, is_meshed_alike_each_time)
{
  const auto entries = "Cells = tetrahedra; Cell size = 0.006";
  const auto first   = make_mesh<3>(entries);
  const auto second  = make_mesh<3>(entries);
  ASSERT_EQ(first->triangulation.n_vertices(),
            second->triangulation.n_vertices());
  for (unsigned int v = 0; v < first->triangulation.n_vertices(); ++v)
    EXPECT_EQ(first->triangulation.get_vertices()[v],
              second->triangulation.get_vertices()[v]);
}

TEST(Cell, is_regular_and_as_large_as_asked_for)
{
  const auto expect_cell = [](const auto &mesh, const double measure) {
    const auto &triangulation = mesh.triangulation;
    ASSERT_EQ(triangulation.n_active_cells(), 1u);
    const auto cell = triangulation.begin_active();
    for (unsigned int line = 0; line < cell->n_lines(); ++line)
      EXPECT_NEAR(cell->line(line)->diameter(), 0.02, 1e-15);
    EXPECT_NEAR(measure_of(mesh), measure, 1e-12 * measure);
  };
  const double square = 4e-4, cube = 8e-6;
  expect_cell(*make_mesh<2>("Object = cell; Size = 0.02"), square);
  expect_cell(*make_mesh<2>("Object = cell; Cells = triangles; Size = 0.02"),
              std::sqrt(3.) / 4. * square);
  expect_cell(*make_mesh<3>("Object = cell; Size = 0.02, 0.02, 0.02"), cube);
  expect_cell(*make_mesh<3>("Object = cell; Cells = tetrahedra; Size = 0.02"),
              cube / (6. * std::sqrt(2.)));
}


TEST(Cylinder, of_hexahedra)
{
  const auto mesh =
    make_mesh<3>("Object = cylinder; Cell size = 0.005, 0.0024, 0.001");
  expect_counts(*mesh, 5 * 136, 4 * 125);

  const auto table = boundary_table(*mesh);
  ASSERT_EQ(table.size(), 3u);
  const double disc = M_PI * 0.01 * 0.01;
  EXPECT_EQ(table[0].name, "x min");
  EXPECT_EQ(table[0].n_faces, 125u);
  EXPECT_NEAR(table[0].area, disc, 0.02 * disc);
  EXPECT_EQ(table[1].name, "x max");
  EXPECT_NEAR(table[1].area, table[0].area, 1e-12 * disc);
  EXPECT_EQ(table[2].name, "mantle");
  EXPECT_EQ(table[2].n_faces, 80u);
  EXPECT_NEAR(table[2].area, M_PI * 0.02 * 0.02, 0.02 * M_PI * 0.02 * 0.02);
  EXPECT_NEAR(measure_of(*mesh), 0.02 * table[0].area, 1e-12 * disc);
}

TEST(Cylinder, of_hexahedra_has_good_cells_at_every_size)
{
  for (const double h : {0.03, 0.01, 0.004, 0.002, 0.001})
    {
      const auto mesh =
        find_object("cylinder")
          .describe(
            {3, 3, CellKind::hexahedron, {0.02, 0.02, 0.02}, {h}, "", 1.});
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (const double j : scaled_jacobians(mesh, c))
          ASSERT_GT(j, 0.7);
    }
}

TEST(Cylinder, of_tetrahedra)
{
  const auto mesh  = make_mesh<3>("Object = cylinder; Cells = tetrahedra; "
                                  "Cell size = 0.0025; "
                                  "Size = 0.03, 0.02, 0.02");
  const auto table = boundary_table(*mesh);
  ASSERT_EQ(table.size(), 3u);
  const double disc = M_PI * 0.01 * 0.01;
  EXPECT_NEAR(table[0].area, disc, 0.02 * disc);
  EXPECT_NEAR(table[1].area, disc, 0.02 * disc);
  EXPECT_NEAR(table[2].area, M_PI * 0.02 * 0.03, 0.02 * M_PI * 0.02 * 0.03);
  EXPECT_NEAR(measure_of(*mesh), 0.03 * disc, 0.02 * 0.03 * disc);
}

TEST(Build, indices_are_those_of_the_description)
{
  for (const CellKind kind : {CellKind::tetrahedron, CellKind::hexahedron})
    {
      const auto description =
        find_object("cylinder")
          .describe({3, 3, kind, {0.02, 0.02, 0.02}, {0.005}, "", 1.});
      const auto mesh = build_mesh<3>(description);
      ASSERT_EQ(mesh->triangulation.n_vertices(), description.vertices.size());
      for (unsigned int v = 0; v < description.vertices.size(); ++v)
        for (int d = 0; d < 3; ++d)
          EXPECT_EQ(mesh->triangulation.get_vertices()[v][d],
                    description.vertices[v][d]);
      for (const auto &cell : mesh->triangulation.active_cell_iterators())
        {
          std::set<unsigned int> ours, theirs;
          for (int i = 0; i < n_vertices(kind); ++i)
            {
              ours.insert(description.cell(cell->active_cell_index())[i]);
              theirs.insert(cell->vertex_index(i));
            }
          EXPECT_EQ(ours, theirs);
        }
    }
}

TEST(Build, ranks_share_the_cells)
{
  const auto description = find_object("box").describe(
    {2, 2, CellKind::triangle, {0.02, 0.02}, {0.0025}, "", 1.});
  const auto mesh = build_mesh<2>(description, 3);
  std::vector<unsigned int> n_cells(3, 0);
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    ++n_cells.at(cell->subdomain_id());
  for (const unsigned int n : n_cells)
    EXPECT_GT(n, description.n_cells() / 5);
}

TEST(Boundaries, are_found_by_numbers_and_names)
{
  const auto mesh = make_mesh<3>("Cell size = 0.01");
  EXPECT_EQ(find_boundaries(*mesh, {"0", "z max"}, "Loads/Fixed boundaries"),
            (std::set<dealii::types::boundary_id>{0, 5}));
  EXPECT_TRUE(find_boundaries(*mesh, {}, "Loads/Fixed boundaries").empty());
  expect_error(
    [&]() { find_boundaries(*mesh, {"6"}, "Loads/Fixed boundaries"); },
    {"Loads/Fixed boundaries", "no boundary '6'", "0 'x min'", "5 'z max'"});
  expect_error(
    [&]() { find_boundaries(*mesh, {"x mim"}, "Loads/Fixed boundaries"); },
    {"Did you mean 'x min'?"});
  EXPECT_NE(format_boundary_table<3>(boundary_table(*mesh)).find("area [m^2]"),
            std::string::npos);
}

TEST(Entries, of_bad_values_are_refused)
{
  using Case = std::pair<std::string, std::vector<std::string>>;
  const std::vector<Case> cases = {
    {"Object = boxx", {"Geometry/Object", "Did you mean 'box'?"}},
    {"Object = cylinder", {"Geometry/Object", "dimension 3"}},
    {"Cells = hexahedra", {"Geometry/Cells", "dimension 2", "triangles"}},
    {"Cells = triangle", {"Did you mean 'triangles'?"}},
    {"Size = 0.02", {"Geometry/Size", "1 numbers", "2 lengths"}},
    {"Size = 0.02, 0", {"Geometry/Size", "'0'"}},
    {"Size = 0.02, -1", {"Geometry/Size", "'-1'"}},
    {"Cell size = 0", {"Geometry/Cell size", "'0'"}},
    {"Cell size = 1e-7", {"Geometry/Cell size", "4e+10", "cells"}},
    {"Cell size = 1, 1, 1", {"Geometry/Cell size", "3 numbers"}},
    {"Cells = triangles; Cell size = 1, 1", {"only quadrilaterals"}},
    {"Object = file", {"Geometry/File", "no file"}},
    {"Object = file; File = a.msh; Scale = 0", {"Geometry/Scale"}},
    {"Object = file; File = a.msh", {"a.msh", "does not exist"}}};
  for (const auto &[entries, words] : cases)
    expect_error([&, e = entries]() { make_mesh<2>(e); }, words);
  expect_error(
    []() { make_mesh<3>("Object = cylinder; Size = 0.02, 0.02, 0.03"); },
    {"Geometry/Size", "height, diameter, diameter"});

  const ObjectRequest nan{
    2, 2, CellKind::triangle, {0.02, std::nan("")}, {0.01}, "", 1.};
  expect_error([&]() { find_object("box").check(nan); }, {"Geometry/Size"});
}
