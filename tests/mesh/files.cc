// Meshes and geometries from files.

#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/materials.h>

#include <gmsh.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "messages.h"
#include "scene.h"

using namespace springfit;

namespace
{
  template <int dim>
  std::unique_ptr<Mesh<dim>>
  read(const std::string &file, const std::string &more = "Scale = 1")
  {
    return make_mesh<dim>("Object = file; File = " + file + "; " + more,
                          MESH_DATA);
  }

  using Ids = std::set<dealii::types::material_id>;

  void
  read_bad(const std::string &file, const std::vector<std::string> &words)
  {
    expect_error(
      [&]() { make_mesh<2>("Object = file; File = " + file, BAD_MESHES); },
      words);
  }

  bool
  has_warning(const std::vector<std::string> &warnings, const std::string &word)
  {
    for (const std::string &warning : warnings)
      if (warning.find(word) != std::string::npos)
        return true;
    return false;
  }

  void
  expect_plate(const Mesh<2> &mesh)
  {
    EXPECT_EQ(mesh.triangulation.n_vertices(), 9u);
    EXPECT_EQ(mesh.triangulation.n_active_cells(), 4u);
    EXPECT_NEAR(measure_of(mesh), 4e-4, 1e-16);

    const auto table = boundary_table(mesh);
    ASSERT_EQ(table.size(), 3u);
    EXPECT_EQ(table[0].id, 0u);
    EXPECT_EQ(table[0].n_faces, 4u);
    EXPECT_EQ(table[1].id, 5u);
    EXPECT_EQ(table[1].name, "left");
    EXPECT_NEAR(table[1].area, 0.02, 1e-15);
    EXPECT_EQ(table[2].id, 9u);
    EXPECT_EQ(table[2].name, "right");

    const auto materials = material_table(mesh);
    ASSERT_EQ(materials.size(), 2u);
    EXPECT_EQ(materials[0].id, 3u);
    EXPECT_EQ(materials[0].n_cells, 2u);
    EXPECT_EQ(materials[1].id, 12u);
    EXPECT_EQ(find_materials(mesh, "stiff part", "E"), Ids{12});
    EXPECT_EQ(find_materials(mesh, "3", "E"), Ids{3});
    expect_error([&]() { find_materials(mesh, "stif part", "Material/E"); },
                 {"Material/E", "Did you mean 'stiff part'?", "3 'soft part'"});
    EXPECT_TRUE(has_warning(mesh.warnings, "4 of 8 boundary edges"));
  }
} // namespace


TEST(File, keeps_ids_names_and_gaps)
{
  expect_plate(*read<2>("plate_v2.msh"));
  expect_plate(*read<2>("plate_v41.msh"));
}

TEST(File, has_the_groups_of_each_element)
{
  expect_plate(*read<2>("groups_by_element.msh"));
}

namespace
{
  double
  length_of(const Mesh<2> &mesh, const std::string &boundary)
  {
    double length  = 0.;
    const auto ids = find_boundaries(mesh, {boundary}, "E");
    for (const auto &row : boundary_table(mesh))
      if (ids.count(row.id) > 0)
        length += row.area;
    return length;
  }
} // namespace

TEST(File, of_gmsh_may_have_groups_that_overlap_or_share_a_name)
{
  const auto by_element = read<2>("overlapping_groups.msh");
  EXPECT_NEAR(length_of(*by_element, "wall"), 2., 1e-15);
  EXPECT_NEAR(length_of(*by_element, "held"), 3., 1e-15);
  EXPECT_EQ(find_materials(*by_element, "plate", "E"), (Ids{9, 10}));
  EXPECT_TRUE(has_warning(by_element->warnings, "5 ('held') mean the sides"));

  const auto by_entity = read<2>("overlapping_entities.msh");
  EXPECT_NEAR(length_of(*by_entity, "bottom"), 2., 1e-15);
  EXPECT_NEAR(length_of(*by_entity, "held"), 3., 1e-15);
}

TEST(File, may_give_a_side_several_ids)
{
  const auto mesh = read<2>("overlapping_references.mesh");
  EXPECT_NEAR(length_of(*mesh, "1"), 2., 1e-15);
  EXPECT_NEAR(length_of(*mesh, "5"), 2., 1e-15);
  EXPECT_TRUE(has_warning(mesh->warnings, "3 of 6 boundary edges"));
  EXPECT_TRUE(has_warning(mesh->warnings, "left out: 1 of '7'"));
}

TEST(File, is_scaled)
{
  const auto mesh = read<2>("plate_v2.msh", "Scale = 0.001");
  EXPECT_NEAR(measure_of(*mesh), 4e-10, 1e-22);
}

TEST(File, in_two_parts_gives_a_warning)
{
  EXPECT_TRUE(has_warning(read<2>("two_parts.msh")->warnings,
                          "2 parts without a common vertex, of 2, 2 cells"));
}

TEST(File, that_is_clockwise_is_reordered)
{
  const auto mesh =
    make_mesh<2>("Object = file; File = clockwise.msh", BAD_MESHES);
  EXPECT_NEAR(measure_of(*mesh), 4e-4, 1e-16);
  EXPECT_TRUE(has_warning(mesh->warnings, "clockwise"));
}

TEST(File, with_a_plane_geometry_is_meshed)
{
  const double hole = M_PI * 16e-6;
  for (const std::string cells : {"triangles", "quadrilaterals"})
    {
      const auto mesh =
        read<2>("plate.geo",
                "Scale = 0.001; Cell size = 0.001; Cells = " + cells);
      EXPECT_EQ(word_of(cell_kind_words(), mesh->cell_kind), cells);
      EXPECT_NEAR(measure_of(*mesh), 6e-4 - hole, 0.02 * hole);
      const auto left = find_boundaries(*mesh, {"left"}, "E");
      EXPECT_EQ(left, (std::set<dealii::types::boundary_id>{4}));
      EXPECT_NEAR(boundary_table(*mesh)[1].area, 0.02, 1e-12);
      EXPECT_EQ(material_table(*mesh)[0].name, "steel");
      const double n = mesh->triangulation.n_active_cells();
      EXPECT_NEAR(n, cells == "triangles" ? 1300 : 600, 0.3 * n);
    }
}

TEST(File, with_a_solid_geometry_is_meshed_but_not_with_hexahedra)
{
  const auto mesh =
    read<3>("rod.geo", "Scale = 0.01; Cell size = 0.004; Cells = tetrahedra");
  EXPECT_NEAR(measure_of(*mesh), 3e-6, 1e-15);
  // without physical surfaces, gmsh's own numbers tell the sides apart
  EXPECT_EQ(boundary_table(*mesh).size(), 6u);
  EXPECT_EQ(boundary_table(*mesh)[0].id, 1u);
  EXPECT_TRUE(has_warning(mesh->warnings, "serve as ids"));

  expect_error([]() { read<3>("rod.geo", "Cells = hexahedra"); },
               {"Geometry/Cells", "hexahedra", "tetrahedra"});
  expect_error([]() { read<2>("rod.geo"); },
               {"geometry of dimension 3", "cells of dimension 2"});
  expect_error(
    []() { read<3>("rod.geo", "Cells = tetrahedra; Cell size = 0"); },
    {"Geometry/Cell size", "'0'"});
  expect_error(
    []() { read<3>("rod.geo", "Cells = tetrahedra; Cell size = 1e-4"); },
    {"Geometry/Cell size", "cells"});
}

TEST(File, with_cells_of_its_own_has_no_cell_size)
{
  for (const std::string file : {"plate_v2.msh", "plate.inp"})
    expect_error([&]() { read<2>(file, "Cell size = 0.0025"); },
                 {"Geometry/Cell size", file, "has its own cells"});
}

TEST(File, of_every_format_is_read)
{
  const auto folder =
    std::filesystem::temp_directory_path() / "springfit_mesh_formats";
  std::filesystem::create_directories(folder);
  const std::vector<std::string> formats = {"msh", "vtk", "unv", "mesh", "bdf"};
  {
    const GmshSession session;
    gmsh::model::occ::addBox(0, 0, 0, 1, 2, 3);
    gmsh::model::occ::synchronize();
    set_gmsh_cell_size(1.);
    gmsh::model::addPhysicalGroup(2, {1}, 17);
    gmsh::model::addPhysicalGroup(2, {2, 3, 4, 5, 6}, 19);
    gmsh::model::addPhysicalGroup(3, {1}, 5);
    mesh_gmsh_model("test", 3);
    for (const double version : {1., 2.2, 3., 4., 4.1})
      {
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::write(folder / ("box" + std::to_string(version) + ".msh"));
      }
    gmsh::option::setNumber("Mesh.Binary", 1);
    for (const double version : {2.2, 4.1})
      {
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::write(folder / ("binary" + std::to_string(version) + ".msh"));
      }
    gmsh::option::setNumber("Mesh.Binary", 0);
    for (const std::string format : {"vtk", "unv", "mesh", "bdf", "inp"})
      gmsh::write(folder / ("box." + format));
  }

  unsigned int n_cells = 0, n_files = 0;
  for (const auto &file : std::filesystem::directory_iterator(folder))
    {
      const std::string name = file.path().filename();
      SCOPED_TRACE(name);
      const auto mesh = make_mesh<3>("Object = file; File = " + name, folder);
      EXPECT_NEAR(measure_of(*mesh), 6., 1e-5);
      EXPECT_EQ(mesh->cell_kind, CellKind::tetrahedron);
      if (n_cells == 0)
        n_cells = mesh->triangulation.n_active_cells();
      EXPECT_EQ(mesh->triangulation.n_active_cells(), n_cells);
      if (name.find("msh") != std::string::npos || name == "box.unv")
        {
          const auto table = boundary_table(*mesh);
          ASSERT_EQ(table.size(), 2u);
          EXPECT_EQ(table[0].id, 17u);
          EXPECT_NEAR(table[0].area, 6., 1e-6);
          EXPECT_EQ(table[1].id, 19u);
          EXPECT_EQ(material_table(*mesh)[0].id, 5u);
        }
      ++n_files;
    }
  EXPECT_EQ(n_files, 12u);
  std::filesystem::remove_all(folder);
}

TEST(File, of_abaqus_has_its_element_sets)
{
  const auto mesh = read<2>("plate.inp");
  EXPECT_EQ(mesh->cell_kind, CellKind::quadrilateral);
  EXPECT_NEAR(measure_of(*mesh), 4e-4, 1e-16);
  EXPECT_EQ(find_boundaries(*mesh, {"left", "right"}, "E").size(), 2u);
  EXPECT_NEAR(boundary_table(*mesh)[1].area, 0.02, 1e-15);
  const auto materials = material_table(*mesh);
  ASSERT_EQ(materials.size(), 1u);
  EXPECT_EQ(materials[0].name, "soft part");
  EXPECT_EQ(materials[0].n_cells, 4u);
  // A set without a section takes no cells from the material.
  expect_error([&]() { find_materials(*mesh, "stiff part", "E"); },
               {"'stiff part'", "no section of its own", "1 'soft part'"});

  // Without sections a set of all cells of some materials names them.
  const auto groups = read<2>("physical_groups.inp");
  EXPECT_EQ(material_table(*groups).size(), 3u);
  EXPECT_EQ(find_materials(*groups, "soft", "E"),
            (std::set<dealii::types::material_id>{1, 2}));
  EXPECT_EQ(find_materials(*groups, "stiff", "E"),
            (std::set<dealii::types::material_id>{3}));
  EXPECT_EQ(find_materials(*groups, "Surface2", "E"),
            (std::set<dealii::types::material_id>{2}));
  expect_error([&]() { find_materials(*groups, "all", "E"); },
               {"'all'", "no section of its own"});

  read_bad("unknown_type.inp", {"line 7", "'XYZ9' is not known"});
  read_bad("unknown_node.inp", {"element 1", "node 5"});
  read_bad("no_number.inp", {"line 3", "cannot be read"});
}

TEST(File, of_abaqus_has_its_instances_where_they_are_placed)
{
  const auto mesh = read<3>("two_instances.inp");
  EXPECT_EQ(mesh->triangulation.n_vertices(), 16u);
  EXPECT_NEAR(measure_of(*mesh), 2., 1e-14);
  const auto area = [&](const std::string &name) {
    double sum     = 0.;
    const auto ids = find_boundaries(*mesh, {name}, "E");
    for (const auto &row : boundary_table(*mesh))
      if (ids.count(row.id) > 0)
        sum += row.area;
    return sum;
  };
  EXPECT_NEAR(area("bottom"), 2., 1e-14);
  EXPECT_NEAR(area("I1.bottom"), 1., 1e-14);
  EXPECT_NEAR(area("TOP1"), 1., 1e-14);
  EXPECT_NEAR(area("s"), 1., 1e-14);
  EXPECT_EQ(find_materials(*mesh, "steel", "E"), Ids{1});
  EXPECT_TRUE(has_warning(mesh->warnings, "*STEP, *STATIC"));
  EXPECT_TRUE(has_warning(mesh->warnings, "1 of type SPRING1"));
}

TEST(File, of_abaqus_says_which_nodes_lack_coordinates)
{
  EXPECT_TRUE(has_warning(read<2>("short_nodes.inp")->warnings,
                          "1 nodes have fewer coordinates"));
}

TEST(File, of_medit_may_have_its_counts_in_the_line_of_the_keyword)
{
  const auto mesh = read<3>("counts_in_line.mesh");
  EXPECT_NEAR(measure_of(*mesh), 1. / 6., 1e-15);
  EXPECT_EQ(material_table(*mesh)[0].id, 7u);
  EXPECT_EQ(find_boundaries(*mesh, {"5"}, "E").size(), 1u);
  EXPECT_TRUE(has_warning(mesh->warnings, "1 of the 5 nodes"));
}

TEST(File, of_medit_may_have_its_keywords_in_any_case)
{
  const auto mesh = read<2>("capitals.mesh");
  EXPECT_NEAR(measure_of(*mesh), 0.5, 1e-15);
  EXPECT_EQ(material_table(*mesh)[0].id, 4u);
  EXPECT_FALSE(has_warning(mesh->warnings, "'End'"));
}

TEST(File, of_abaqus_may_give_normals_to_some_nodes)
{
  const auto mesh = read<2>("normals.inp");
  EXPECT_NEAR(measure_of(*mesh), 0.5, 1e-15);
  EXPECT_FALSE(has_warning(mesh->warnings, "coordinates"));
}

TEST(File, of_nastran_may_mark_its_continuations)
{
  EXPECT_NEAR(measure_of(*read<3>("marked_continuation.bdf")), 0.015, 1e-12);
}

// Small, large and free fields, blanks for 0, what is no part of the mesh, and
// cards behind the end, which Nastran does not read.
TEST(File, of_nastran_is_read_up_to_its_end)
{
  const auto mesh = read<3>("everyday.bdf");
  EXPECT_NEAR(measure_of(*mesh), 0.015, 1e-12);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 1u);
  EXPECT_EQ(material_table(*mesh)[0].id, 3u);
  EXPECT_EQ(find_boundaries(*mesh, {"9"}, "E"), Ids{9});
  EXPECT_TRUE(has_warning(mesh->warnings, "1 CBAR, 1 CONM2"));
  EXPECT_TRUE(has_warning(mesh->warnings, "MAT1, PSOLID"));
}

TEST(File, of_universal_format_has_groups_of_nodes_sides_and_cells)
{
  const auto mesh = read<3>("groups.unv");
  EXPECT_NEAR(measure_of(*mesh), 1. / 6. + 1. / 3., 1e-15);
  const auto table = boundary_table(*mesh);
  EXPECT_EQ(find_boundaries(*mesh, {"base"}, "E"), Ids{7});
  EXPECT_EQ(find_boundaries(*mesh, {"some nodes"}, "E"), Ids{2});
  EXPECT_EQ(find_materials(*mesh, "soft", "E"), Ids{4});
  EXPECT_EQ(find_materials(*mesh, "stiff", "E"), Ids{5});
  for (const auto &row : table)
    EXPECT_NEAR(row.area, row.id == 0 ? 0.5 + 1.5 * std::sqrt(3.) : 0.5, 1e-14);
  expect_error([&]() { find_boundaries(*mesh, {"interface"}, "E"); },
               {"'interface'", "lies inside the body"});
  expect_error([&]() { find_boundaries(*mesh, {"soft"}, "E"); },
               {"'soft'", "group of cells"});
  expect_error([&]() { find_boundaries(*mesh, {"corner"}, "E"); },
               {"'corner'", "no whole face"});
  EXPECT_TRUE(has_warning(mesh->warnings, "1 of the 6 nodes"));
  EXPECT_TRUE(has_warning(mesh->warnings, "1 of type 136"));
  EXPECT_TRUE(has_warning(mesh->warnings, "'corner' (1)"));
  read_bad("other_system.unv", {"line 18", "coordinate system 1"});
  read_bad("short_group.unv", {"'some nodes'", "4 announced"});
}

// Nodes of one line each, a beam, and data that are no part of the mesh.
TEST(File, of_universal_format_may_state_its_unit)
{
  const auto mesh = read<3>("millimetres.unv");
  EXPECT_NEAR(measure_of(*mesh), 1. / 6., 1e-15);
  EXPECT_TRUE(has_warning(mesh->warnings, "unit of length is 0.001 m"));
  EXPECT_TRUE(has_warning(mesh->warnings, "passed over: 1710"));
  EXPECT_TRUE(has_warning(mesh->warnings, "left out: 1 of type '21"));
  EXPECT_FALSE(
    has_warning(read<3>("millimetres.unv", "Scale = 0.001")->warnings,
                "unit of length"));
}

namespace
{
  std::string
  bytes_of(const std::filesystem::path &file)
  {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
} // namespace

namespace
{
  std::string
  binary_square(const double version, const std::filesystem::path &folder)
  {
    const GmshSession session;
    gmsh::model::occ::addRectangle(0, 0, 0, 1, 1);
    gmsh::model::occ::synchronize();
    set_gmsh_cell_size(0.5);
    mesh_gmsh_model("test", 2);
    gmsh::option::setNumber("Mesh.MshFileVersion", version);
    gmsh::option::setNumber("Mesh.Binary", 1);
    gmsh::write(folder / "whole.msh");
    return bytes_of(folder / "whole.msh");
  }
} // namespace

// gmsh 4.8 reads such files without a word.
TEST(File, of_gmsh_in_binary_is_counted)
{
  const auto folder =
    std::filesystem::temp_directory_path() / "springfit_binary_msh";
  std::filesystem::create_directories(folder);
  for (const double version : {2.2, 4.1})
    {
      SCOPED_TRACE(version);
      const std::string whole = binary_square(version, folder);
      const auto read_bytes   = [&](const std::string &bytes) {
        std::ofstream(folder / "changed.msh", std::ios::binary) << bytes;
        return make_mesh<2>("Object = file; File = changed.msh", folder);
      };
      EXPECT_NEAR(measure_of(*read_bytes(whole)), 1., 1e-12);
      const auto elements = whole.find("$Elements");
      expect_error([&]() { read_bytes(whole.substr(0, elements + 60)); },
                   {"changed.msh", "the file ends before"});

      const std::size_t end  = whole.find("\n$EndElements");
      const std::size_t size = version == 4.1 ? 8 : 4; // of a number
      std::string elsewhere  = whole;
      elsewhere.replace(end - size, 2, "\x7f\x7f");
      expect_error([&]() { read_bytes(elsewhere); },
                   {"changed.msh", "which is not there"});
      if (version == 2.2) // where gmsh writes blocks of one
        continue;
      // The last triangle gets the number of the one before.
      const std::size_t n = 4 * size;
      std::string doubled = whole;
      doubled.replace(end - n, size, whole.substr(end - 2 * n, size));
      expect_error([&]() { read_bytes(doubled); },
                   {"changed.msh", "a second time"});
    }
  std::filesystem::remove_all(folder);
}

TEST(File, of_gmsh_says_which_groups_are_inside)
{
  const auto folder =
    std::filesystem::temp_directory_path() / "springfit_inner_group";
  std::filesystem::create_directories(folder);
  {
    const GmshSession session;
    gmsh::model::occ::addBox(0, 0, 0, 1, 1, 1);
    gmsh::model::occ::addBox(1, 0, 0, 1, 1, 1);
    gmsh::vectorpair out;
    std::vector<gmsh::vectorpair> map;
    gmsh::model::occ::fragment({{3, 1}}, {{3, 2}}, out, map);
    gmsh::model::occ::synchronize();
    gmsh::vectorpair between;
    gmsh::model::getEntitiesInBoundingBox(0.9, -1, -1, 1.1, 2, 2, between, 2);
    ASSERT_EQ(between.size(), 1u);
    set_gmsh_cell_size(1.);
    gmsh::model::setPhysicalName(
      2, gmsh::model::addPhysicalGroup(2, {between[0].second}), "between");
    gmsh::model::setPhysicalName(2,
                                 gmsh::model::addPhysicalGroup(2, {1}),
                                 "outside");
    gmsh::model::setPhysicalName(3,
                                 gmsh::model::addPhysicalGroup(3, {1, 2}),
                                 "flesh");
    mesh_gmsh_model("test", 3);
    gmsh::write(folder / "two.msh");
  }
  const auto mesh = make_mesh<3>("Object = file; File = two.msh", folder);
  expect_error([&]() { find_boundaries(*mesh, {"between"}, "E"); },
               {"'between'", "lies inside the body", "'outside'"});
  expect_error([&]() { find_boundaries(*mesh, {"flesh"}, "E"); },
               {"'flesh'", "group of cells"});
  expect_error([&]() { find_materials(*mesh, "outside", "E"); },
               {"'outside'", "no group of cells"});
  std::filesystem::remove_all(folder);
}

TEST(File, of_gmsh_says_which_groups_are_empty)
{
  const auto mesh = read<2>("empty_group.msh");
  EXPECT_TRUE(has_warning(mesh->warnings, "hold no elements: 'no where'"));
  expect_error([&]() { find_boundaries(*mesh, {"no where"}, "E"); },
               {"'no where'", "holds no elements"});
  EXPECT_EQ(find_boundaries(*mesh, {"left"}, "E"), Ids{1});
}

TEST(File, of_vtk_may_be_new_and_its_arrays_name_materials)
{
  const auto mesh = read<2>("version_5.vtk", "Material ids = tissue");
  EXPECT_NEAR(measure_of(*mesh), 2., 1e-15);
  const auto materials = material_table(*mesh);
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0].id, 3u);
  EXPECT_EQ(materials[1].id, 8u);
  EXPECT_TRUE(has_warning(read<2>("version_5.vtk")->warnings, "'tissue'"));
  expect_error([]() { read<2>("version_5.vtk", "Material ids = bone"); },
               {"Geometry/Material ids", "no cell array 'bone'", "'tissue'"});
}

TEST(File, of_abaqus_has_what_decks_have_every_day)
{
  const auto mesh = read<3>("everyday.inp");
  EXPECT_NEAR(measure_of(*mesh), 0.25 / 6., 1e-16);
  EXPECT_EQ(find_materials(*mesh, "soft", "E"), Ids{1});
  EXPECT_EQ(find_materials(*mesh, "body", "E"), Ids{1});
  ASSERT_EQ(find_boundaries(*mesh, {"side"}, "E").size(), 1u);
  EXPECT_TRUE(has_warning(mesh->warnings, "1 of the 5 nodes"));
  EXPECT_TRUE(has_warning(mesh->warnings, "1 of type MASS"));
  expect_error([&]() { find_boundaries(*mesh, {"base"}, "E"); },
               {"'base'", "holds no whole face"});
}

TEST(File, that_loses_something_is_refused)
{
  const std::string again = "a second time";
  read_bad("repeated_element.msh", {"line 16", "element 1", again});
  read_bad("too_few_elements.msh", {"line 17", "element 3 of the 3"});
  read_bad("too_many_elements.msh", {"line 16", "$EndElements"});
  read_bad("cut_short.mesh",
           {"the file ends where number 2 of the 2 Triangles"});
  read_bad("cut_short.bdf", {"line 7", "element 2", "3 nodes instead of 4"});
  read_bad("other_system.bdf", {"line 4", "coordinate system 5"});
  read_bad("word_as_coordinate.bdf", {"line 2", "'abc'"});
  read_bad("include.bdf", {"line 2", "INCLUDE"});
  read_bad("repeated_card.bdf", {"line 2", "does not repeat cards"});
  read_bad("unknown_card.bdf", {"line 4", "'CTRIAX6' is not known"});
  read_bad("no_such_type.msh", {"line 11", "the type 1850024970"});
  read_bad("part_without_instance.inp", {"line 1", "no *INSTANCE"});
  read_bad("long_element.inp", {"4 nodes instead of 3", "type that has"});
  read_bad("face_of_shell.inp", {"line 8", "'SPOS' is no side"});
  read_bad("polydata.vtk", {"is a POLYDATA", "'Append Datasets'"});
  read_bad("lines.msh", {"1 of dimension 1", "of lines alone"});
  read_bad("negative_reference.mesh", {"line 7", "reference -1 is no id"});
  read_bad("large_group.msh", {"line 10", "99999999999 is no id"});
  read_bad("cut_short.unv", {"line 1", "the file ends before the data set"});
  read_bad("cut_short.vtk", {"the file ends too early"});
  read_bad("copied_nodes.inp", {"line 6", "*NCOPY"});
  read_bad("repeated_element.inp", {"line 8", "element 1", again});
  read_bad("short_element.inp", {"line 7", "3 nodes instead of 4"});
  read_bad("number_with_tail.inp", {"line 3", "'2.x'"});
}

TEST(File, of_a_format_that_is_not_read_says_what_it_is)
{
  read_bad("ucd.inp", {"line 1", "AVS-UCD"});
  read_bad("xml.vtu", {"VTK XML", "meshio convert"});
  read_bad("surface.stl", {"surface without cells", "Surface Loop(1)"});
}

TEST(File, whose_ending_is_in_capitals_is_read)
{
  const auto folder =
    std::filesystem::temp_directory_path() / "springfit_capitals";
  std::filesystem::create_directories(folder);
  for (const std::string ending : {"msh", "inp"})
    {
      const std::string name = ending == "msh" ? "PLATE.MSH" : "PLATE.INP";
      std::filesystem::copy_file(
        std::string(MESH_DATA) +
          (ending == "msh" ? "/plate_v2.msh" : "/plate.inp"),
        folder / name,
        std::filesystem::copy_options::overwrite_existing);
      EXPECT_NEAR(measure_of(
                    *make_mesh<2>("Object = file; File = " + name, folder)),
                  4e-4,
                  1e-16);
    }
  std::filesystem::remove_all(folder);
}

// gmsh runs the file mesh.msh.opt when it opens mesh.msh.
TEST(File, with_options_beside_it_runs_no_command)
{
  const auto folder =
    std::filesystem::temp_directory_path() / "springfit_options";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(std::string(MESH_DATA) + "/plate_v2.msh",
                             folder / "plate.msh");
  std::ofstream(folder / "plate.msh.opt")
    << "SystemCall \"touch " << (folder / "called").string() << "\";\n";
  make_mesh<2>("Object = file; File = plate.msh", folder);
  EXPECT_FALSE(std::filesystem::exists(folder / "called"));
  std::filesystem::remove_all(folder);
}

TEST(File, that_is_huge_asks_about_its_scale)
{
  EXPECT_TRUE(has_warning(read<2>("plate_v2.msh", "Scale = 1000")->warnings,
                          "Is Geometry/Scale = 1000 right?"));
  EXPECT_FALSE(has_warning(read<2>("plate_v2.msh")->warnings, "right?"));
}

TEST(File, of_step_is_taken_in_metres)
{
  const auto folder = std::filesystem::temp_directory_path() / "springfit_step";
  std::filesystem::create_directories(folder);
  {
    const GmshSession session;
    gmsh::model::occ::addBox(0, 0, 0, 10, 20, 30); // mm
    gmsh::model::occ::synchronize();
    gmsh::write(folder / "box.step");
  }
  const auto mesh = make_mesh<3>(
    "Object = file; File = box.step; Cells = tetrahedra; Cell size = 0.01",
    folder);
  EXPECT_NEAR(measure_of(*mesh), 6e-6, 1e-12);
  std::filesystem::remove_all(folder);
}

// As the message on an .stl file has it.
TEST(File, with_a_surface_can_be_filled)
{
  const auto folder = std::filesystem::temp_directory_path() / "springfit_fill";
  std::filesystem::create_directories(folder);
  {
    const GmshSession session;
    gmsh::model::occ::addBox(0, 0, 0, 1, 2, 3);
    gmsh::model::occ::synchronize();
    set_gmsh_cell_size(1.);
    mesh_gmsh_model("test", 2);
    gmsh::write(folder / "mesh.stl");
  }
  std::ofstream(folder / "mesh.geo")
    << "Merge \"mesh.stl\"; Surface Loop(1) = {1}; Volume(1) = {1}; Mesh 3;\n";
  EXPECT_NEAR(measure_of(
                *make_mesh<3>("Object = file; File = mesh.geo", folder)),
              6.,
              1e-5);
  std::filesystem::remove_all(folder);
}

TEST(File, that_is_bad_is_refused)
{
  read_bad("absent.msh", {"Geometry/File", "absent.msh", "does not exist"});
  read_bad(".", {"Geometry/File", "is a directory"});
  read_bad("no_mesh.msh", {"no_mesh.msh", "begin with $MeshFormat", "formats"});
  read_bad("empty.msh", {"no cells of dimension 2", "no elements at all"});
  read_bad(
    "curve_without_surface.msh",
    {"4 of dimension 1", "physical curve", "no physical surface", "-save_all"});
  read_bad("mixed.msh", {"mixed cell types", "3 of type 'Quad", "2 of type"});
  read_bad("second_order.msh", {"order 2", "gmsh -order 1"});
  read_bad("inverted.msh",
           {"quadrilateral 6", "x = 0.015", "inverted", "1 of 4"});
  read_bad("folded.msh", {"folded", "quadrilateral"});
  read_bad("flat_cell.msh", {"triangle 2", "no area"});
  read_bad("duplicate_cell.msh", {"quadrilateral 9", "duplicate"});
  read_bad("not_a_number.msh", {"line 16", "'nan'", "finite"});
  read_bad("not_plane.msh", {"not plane", "z = constant"});
  read_bad("three_cells_on_an_edge.msh", {"3 cells share"});
  read_bad("inverted_tetrahedra.msh",
           {"no cells of dimension 2", "2 of dimension 3"});
}

TEST(File, that_is_bad_in_space_is_refused)
{
  const auto read_solid = [](const std::string &file) {
    make_mesh<3>("Object = file; File = " + file, BAD_MESHES);
  };
  expect_error([&]() { read_solid("prism.msh"); },
               {"does not know", "Prism", "tetrahedra"});
  expect_error([&]() { read_solid("inverted_tetrahedra.msh"); },
               {"tetrahedron 2", "inverted", "volume"});
  expect_error([&]() { read_solid("good.msh"); },
               {"no cells of dimension 3", "4 of dimension 2"});
}
