// Meshes without some of their materials.

#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/build_mesh.h>
#include <springfit/mesh/leave_out.h>
#include <springfit/mesh/materials.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/objects.h>

#include <vector>

#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  /** A unit box whose half of large x is the material 7, "bone". */
  MeshDescription
  half_bone(const CellKind kind)
  {
    const int dim = dimension(kind);
    auto mesh     = find_object("box").describe(
      {dim, dim, kind, std::vector<double>(dim, 1.), {0.25}, "", 1.});
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      {
        double x = 0.;
        for (int a = 0; a < n_vertices(kind); ++a)
          x += mesh.vertices[mesh.cell(c)[a]][0] / n_vertices(kind);
        // Cells of gmsh lie across the middle: the interface is not flat.
        mesh.material_ids[c] = x > 0.5 ? 7 : 0;
      }
    mesh.material_names.emplace(7, "bone");
    return mesh;
  }

  template <int dim>
  double
  boundary_area(const Mesh<dim> &mesh, const std::string &name)
  {
    for (const auto &row : boundary_table(mesh))
      if (row.name == name)
        return row.area;
    return 0.;
  }

  /** Both halves of the box, each without the other. */
  template <int dim>
  void
  expect_half(const CellKind kind)
  {
    auto whole = half_bone(kind);
    auto soft  = whole;
    leave_out(soft, {"bone"});
    auto hard = whole;
    leave_out(hard, {"0"});
    check_mesh(soft);
    check_mesh(hard);
    const auto of_soft = build_mesh<dim>(soft);
    const auto of_hard = build_mesh<dim>(hard);
    EXPECT_NEAR(measure_of(*of_soft) + measure_of(*of_hard), 1., 1e-12);
    EXPECT_GT(measure_of(*of_soft), 0.3);
    EXPECT_GT(measure_of(*of_hard), 0.3);

    // One interface, seen from two sides; the rest is the box's.
    const double area = boundary_area(*of_soft, "bone");
    EXPECT_GE(area, 1. - 1e-12);
    EXPECT_NEAR(boundary_area(*of_hard, "left out 0"), area, 1e-12);
    EXPECT_NEAR(boundary_area(*of_soft, "x min"), 1., 1e-12);
    EXPECT_EQ(boundary_area(*of_soft, "x max"), 0.);
    EXPECT_NEAR(boundary_area(*of_hard, "x max"), 1., 1e-12);
    EXPECT_NEAR(boundary_area(*of_soft, "y min") +
                  boundary_area(*of_hard, "y min"),
                1.,
                1e-12);
  }
} // namespace


TEST(LeaveOut, PartsABodyInTwo)
{
  expect_half<2>(CellKind::triangle);
  expect_half<2>(CellKind::quadrilateral);
  expect_half<3>(CellKind::tetrahedron);
  expect_half<3>(CellKind::hexahedron);
}

TEST(LeaveOut, KeepsTheBoundaryThatAFileHasOnTheInterface)
{
  auto mesh = half_bone(CellKind::quadrilateral);
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    if (mesh.material_ids[c] == 7)
      // Lexicographic: the side of small x.
      if (mesh.vertices[mesh.cell(c)[0]][0] < 0.5 + 1e-12)
        mesh.facets.push_back({{mesh.cell(c)[2], mesh.cell(c)[0]}, 40});
  mesh.boundary_names.emplace(40, "periosteum");
  leave_out(mesh, {"bone"});
  check_mesh(mesh);
  const auto built = build_mesh<2>(mesh);
  EXPECT_NEAR(boundary_area(*built, "periosteum"), 1., 1e-12);
  EXPECT_EQ(boundary_area(*built, "bone"), 0.);
}

TEST(LeaveOut, KeepsNumbersAndGroups)
{
  auto mesh            = half_bone(CellKind::triangle);
  const unsigned int n = mesh.n_cells();
  mesh.cell_numbers    = {};
  mesh.group_begins    = {0};
  for (unsigned int c = 0; c < n; ++c)
    {
      mesh.cell_numbers.push_back(100 + c);
      mesh.material_ids[c] = 3 * c / n;
      if (c > 0 && mesh.material_ids[c] != mesh.material_ids[c - 1])
        mesh.group_begins.push_back(c);
    }
  ASSERT_EQ(mesh.group_begins.size(), 3u);
  mesh.material_names.clear();
  const auto before = mesh;
  leave_out(mesh, {"1"});
  const unsigned int first    = before.group_begins[1];
  const unsigned int left_out = before.group_begins[2] - first;
  EXPECT_EQ(mesh.group_begins, (std::vector<unsigned int>{0, first}));
  EXPECT_EQ(mesh.cell_numbers[first], 100 + before.group_begins[2]);
  EXPECT_EQ(mesh.left_out,
            std::to_string(left_out) + " of " + std::to_string(n) +
              " cells, material 1");
  for (unsigned int c = first; c < mesh.n_cells(); ++c)
    for (unsigned int a = 0; a < 3; ++a)
      EXPECT_EQ(mesh.vertices[mesh.cell(c)[a]],
                before.vertices[before.cell(c + left_out)[a]]);
}

TEST(LeaveOut, RefusesWhatIsNotThereAndToLeaveNothing)
{
  auto mesh = half_bone(CellKind::triangle);
  expect_error([&]() { leave_out(mesh, {"bones"}); },
               {"no material 'bones'", "Did you mean 'bone'"});
  expect_error([&]() { leave_out(mesh, {"bone", "0"}); }, {"no cell is left"});
}

TEST(LeaveOut, IsAnEntryOfTheScene)
{
  const std::string file =
    "Object = file; File = " MESH_DATA "/two_materials.msh";
  const auto whole = make_mesh<2>(file);
  const auto table = material_table(*whole);
  ASSERT_EQ(table.size(), 2u);
  const auto part = make_mesh<2>(file + "; Leave out = bone");
  ASSERT_EQ(material_table(*part).size(), 1u);
  EXPECT_NEAR(measure_of(*part), table[0].measure, 1e-12 * table[0].measure);
  expect_error([&]() { find_materials(*part, "bone", "Material"); },
               {"left out"});
}
