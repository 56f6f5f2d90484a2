// The checks, the sides and the look-up of names: plain numbers.

#include <springfit/mesh/cell_orientation.h>
#include <springfit/mesh/connection.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/name_lookup.h>

#include <cmath>
#include <limits>

#include "messages.h"

using namespace springfit;

namespace
{
  /** Two unit squares beside each other, in lexicographic numbering. */
  MeshDescription
  two_squares()
  {
    MeshDescription mesh;
    mesh.name         = "The mesh";
    mesh.cell_kind    = CellKind::quadrilateral;
    mesh.vertices     = {{{0, 0, 0}},
                         {{1, 0, 0}},
                         {{2, 0, 0}},
                         {{0, 1, 0}},
                         {{1, 1, 0}},
                         {{2, 1, 0}}};
    mesh.cells        = {0, 1, 3, 4, 1, 2, 4, 5};
    mesh.material_ids = {0, 0};
    return mesh;
  }

  MeshDescription
  one_cell(const CellKind kind)
  {
    MeshDescription mesh;
    mesh.name      = "The mesh";
    mesh.cell_kind = kind;
    for (int i = 0; i < n_vertices(kind); ++i)
      {
        const int corner = is_simplex(kind) && i == 3 ? 4 : i;
        mesh.vertices.push_back(
          {{double(corner & 1), double(corner >> 1 & 1), double(corner >> 2)}});
        mesh.cells.push_back(i);
      }
    mesh.material_ids = {0};
    return mesh;
  }

  const std::vector<CellKind> all_kinds = {CellKind::triangle,
                                           CellKind::quadrilateral,
                                           CellKind::tetrahedron,
                                           CellKind::hexahedron};
} // namespace


TEST(Checks, a_good_mesh_passes_without_warning)
{
  for (const CellKind kind : all_kinds)
    {
      MeshDescription mesh = one_cell(kind);
      EXPECT_NO_THROW(check_mesh(mesh));
      EXPECT_TRUE(mesh.warnings.empty());
      EXPECT_EQ(mesh.cells, one_cell(kind).cells);
    }
}

TEST(Checks, jacobians_are_one_at_right_angles_and_scale_free)
{
  MeshDescription mesh = one_cell(CellKind::hexahedron);
  for (MeshPoint &vertex : mesh.vertices)
    {
      vertex[0] *= 1e-9;
      vertex[2] *= 1e3;
    }
  const auto jacobians = scaled_jacobians(mesh, 0);
  ASSERT_EQ(jacobians.size(), 16u);
  for (const double j : jacobians)
    EXPECT_NEAR(j, 1., 1e-14);
  EXPECT_NO_THROW(check_mesh(mesh));
}

TEST(Checks, mirror_images_are_reordered_with_a_warning)
{
  for (const CellKind kind : all_kinds)
    {
      MeshDescription mesh = one_cell(kind);
      for (MeshPoint &vertex : mesh.vertices)
        vertex[0] *= -1.;
      ASSERT_LT(scaled_jacobians(mesh, 0)[0], 0.);
      check_mesh(mesh);
      for (const double j : scaled_jacobians(mesh, 0))
        EXPECT_GT(j, 0.);
      ASSERT_EQ(mesh.warnings.size(), 1u);
      EXPECT_NE(mesh.warnings[0].find("reordered"), std::string::npos);
    }
}

TEST(Checks, a_group_of_clockwise_cells_is_reordered)
{
  MeshDescription mesh = two_squares();
  std::swap(mesh.cells[5], mesh.cells[6]);
  MeshDescription grouped = mesh;
  grouped.group_begins    = {0, 1};
  check_mesh(grouped);
  EXPECT_EQ(grouped.cells, two_squares().cells);
  EXPECT_EQ(grouped.warnings.size(), 1u);

  mesh.cell_numbers = {4, 17};
  expect_error([&]() { check_mesh(mesh); },
               {"quadrilateral 17", "inverted", "x = 1.5", "1 of 2"});
}

TEST(Checks, folded_and_flat_cells_are_refused)
{
  MeshDescription folded = two_squares();
  folded.vertices[5]     = {{0.9, 0.2, 0}};
  expect_error([&]() { check_mesh(folded); }, {"folded", "quadrilateral 1"});

  MeshDescription flat = one_cell(CellKind::tetrahedron);
  flat.vertices[3]     = {{0.3, 0.3, 0.}};
  expect_error([&]() { check_mesh(flat); }, {"no volume", "tetrahedron 0"});

  MeshDescription collapsed = one_cell(CellKind::triangle);
  collapsed.vertices[1]     = collapsed.vertices[0];
  expect_error([&]() { check_mesh(collapsed); }, {"no area"});
}

TEST(Checks, numbers_that_are_none_are_refused)
{
  MeshDescription mesh = two_squares();
  mesh.vertices[2][1]  = std::numeric_limits<double>::quiet_NaN();
  expect_error([&]() { check_mesh(mesh); }, {"3. vertex", "finite"});
}

TEST(Checks, unused_vertices_duplicates_and_no_cells_are_refused)
{
  MeshDescription unused = two_squares();
  unused.vertices.push_back({{5, 5, 0}});
  expect_error([&]() { check_mesh(unused); }, {"7. vertex", "no cell"});

  MeshDescription duplicate = two_squares();
  duplicate.cells.insert(duplicate.cells.end(), {2, 5, 1, 4});
  duplicate.material_ids.push_back(0);
  expect_error([&]() { check_mesh(duplicate); },
               {"quadrilateral 2", "duplicate of quadrilateral 1"});

  MeshDescription empty;
  empty.name = "The mesh";
  expect_error([&]() { check_mesh(empty); }, {"The mesh has no cells"});
}

TEST(Checks, unconnected_parts_give_a_warning)
{
  MeshDescription mesh = two_squares();
  mesh.vertices.push_back({{1, 0, 0}});
  mesh.vertices.push_back({{1, 1, 0}});
  mesh.cells[4] = 6;
  mesh.cells[6] = 7;
  check_mesh(mesh);
  EXPECT_EQ(connected_parts(mesh), (std::vector<unsigned int>{1, 1}));
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].find("2 parts"), std::string::npos);
  EXPECT_NE(mesh.warnings[0].find("1, 1 cells"), std::string::npos);
}

TEST(Sides, each_cell_has_the_right_number)
{
  EXPECT_EQ(boundary_sides(one_cell(CellKind::triangle)).size(), 3u);
  EXPECT_EQ(boundary_sides(one_cell(CellKind::quadrilateral)).size(), 4u);
  EXPECT_EQ(boundary_sides(one_cell(CellKind::tetrahedron)).size(), 4u);
  EXPECT_EQ(boundary_sides(one_cell(CellKind::hexahedron)).size(), 6u);
}

TEST(Sides, those_between_cells_are_not_on_the_boundary)
{
  MeshDescription mesh = two_squares();
  label_boundary(mesh, [](const std::vector<MeshPoint> &points) {
    return points[0][0] == points[1][0] ? 7 : 3;
  });
  ASSERT_EQ(mesh.facets.size(), 6u);
  for (const BoundaryFacet &facet : mesh.facets)
    EXPECT_NE(facet.vertices, (std::vector<unsigned int>{1, 4}));
  EXPECT_EQ(mesh.facets[0].id, 7u); // the left side of the first cell
}

TEST(Sides, three_cells_on_one_are_refused)
{
  MeshDescription mesh = two_squares();
  mesh.vertices.push_back({{3, 0, 0}});
  mesh.vertices.push_back({{3, 1, 0}});
  mesh.cells.insert(mesh.cells.end(), {1, 6, 4, 7});
  mesh.material_ids.push_back(0);
  expect_error([&]() { boundary_sides(mesh); }, {"3 cells share"});
}

TEST(Names, are_found_by_number_and_by_name)
{
  const std::vector<IdAndName> known = {{3, "left"}, {7, ""}, {9, "top side"}};
  EXPECT_EQ(find_ids(known, {}, "7", "boundary", "E"),
            (std::set<unsigned int>{7}));
  EXPECT_EQ(find_ids(known, {}, "top side", "boundary", "E"),
            (std::set<unsigned int>{9}));
  expect_error([&]() { find_ids(known, {}, "lef", "boundary", "Loads/Fixed"); },
               {"Loads/Fixed",
                "no boundary 'lef'",
                "Did you mean 'left'?",
                "3 'left', 7, 9 'top side'"});
  expect_error([&]() { find_ids(known, {}, "", "boundary", "E"); }, {"''"});
}

TEST(Names, that_are_numbers_of_others_are_ambiguous)
{
  const std::vector<IdAndName> known = {{1, "2"},
                                        {2, "7"},
                                        {3, "a, b"},
                                        {4, "4"}};
  using Ids                          = std::set<unsigned int>;
  expect_error([&]() { find_ids(known, {}, "2", "boundary", "E"); },
               {"'2' is the number of one boundary and the name of another",
                "id 2"});
  EXPECT_EQ(find_ids(known, {}, "\"2\"", "boundary", "E"), Ids{1});
  EXPECT_EQ(find_ids(known, {}, "id 2", "boundary", "E"), Ids{2});
  EXPECT_EQ(find_ids(known, {}, "7", "boundary", "E"), Ids{2});
  EXPECT_EQ(find_ids(known, {}, "4", "boundary", "E"), Ids{4});
  EXPECT_EQ(find_ids(known, {}, "\"a, b\"", "boundary", "E"), Ids{3});
}

TEST(Names, that_are_the_number_of_a_group_mean_all_of_it)
{
  EXPECT_EQ(find_ids({{1, "5"}, {1, "7"}, {5, "5"}}, {}, "5", "boundary", "E"),
            (std::set<unsigned int>{1, 5}));
}

TEST(Names, that_are_many_make_no_long_message)
{
  std::vector<IdAndName> known;
  for (unsigned int i = 0; i < 600; ++i)
    known.push_back({i / 20, "name" + std::to_string(i)});
  expect_error([&]() { find_ids(known, {}, "absent", "boundary", "E"); },
               {"'name3' and 16 more", "and 18 more"});
}

TEST(Names, of_several_groups_hold_them_all)
{
  EXPECT_EQ(find_ids({{1, "skin"}, {2, "skin"}, {3, "bone"}},
                     {},
                     "skin",
                     "boundary",
                     "E"),
            (std::set<unsigned int>{1, 2}));
}

TEST(Names, that_are_of_no_use_say_why)
{
  expect_error(
    [&]() {
      find_ids({{1, "skin"}},
               {{"Inner", "lies inside the body"}},
               "inner",
               "boundary",
               "E");
    },
    {"'Inner' is in the file, but it lies inside the body", "1 'skin'"});
}

TEST(Names, the_table_stands_in_columns)
{
  EXPECT_EQ(format_table({"id", "name", "faces", "area"},
                         {{0, "x min", 4, 0.25}, {12, "", 100, 1e-4}}),
            "id : name  : faces : area\n"
            "0  : x min : 4     : 0.25\n"
            "12 : -     : 100   : 0.0001\n");
}
