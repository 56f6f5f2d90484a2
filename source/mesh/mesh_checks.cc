#include <springfit/core/error.h>
#include <springfit/mesh/cell_names.h>
#include <springfit/mesh/cell_orientation.h>
#include <springfit/mesh/connection.h>
#include <springfit/mesh/mesh_checks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace springfit
{
  void
  check_not_empty(const MeshDescription &mesh)
  {
    if (mesh.cells.empty())
      throw InputError(mesh.name + " has no cells.",
                       "Give a mesh with at least one cell.");
  }


  void
  check_coordinates(const MeshDescription &mesh)
  {
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      for (const double x : mesh.vertices[v])
        if (!std::isfinite(x))
          throw InputError(mesh.name + ": the " + std::to_string(v + 1) +
                             ". vertex has a coordinate that is not a finite "
                             "number.",
                           "Write the mesh anew.");
  }


  void
  check_vertices_are_used(const MeshDescription &mesh)
  {
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const unsigned int v : mesh.cells)
      used.at(v) = true;
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end())
      throw InputError(mesh.name + ": the " +
                         std::to_string(unused - used.begin() + 1) +
                         ". vertex belongs to no cell.",
                       "Remove the vertices that no cell uses.");
  }


  void
  check_no_duplicate_cells(const MeshDescription &mesh)
  {
    const unsigned int n_corners = n_vertices(mesh.cell_kind);

    using Key = std::array<unsigned int, 9>; // the last one is the cell
    std::vector<Key> keys(mesh.n_cells(), Key{});
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      {
        std::copy_n(mesh.cell(c), n_corners, keys[c].begin());
        std::sort(keys[c].begin(), keys[c].begin() + n_corners);
        keys[c].back() = c;
      }
    std::sort(keys.begin(), keys.end());

    const auto twin =
      std::adjacent_find(keys.begin(),
                         keys.end(),
                         [](const Key &a, const Key &b) {
                           return std::equal(a.begin(), a.end() - 1, b.begin());
                         });
    if (twin != keys.end())
      throw InputError(mesh.name + ": " +
                         describe_cell(mesh, (twin + 1)->back()) +
                         " is a duplicate of " +
                         describe_cell(mesh, twin->back()) + ".",
                       "Remove one of them; a cell may belong to one physical "
                       "group of cells only.");
  }


  void
  check_mesh(MeshDescription &mesh)
  {
    check_not_empty(mesh);
    check_coordinates(mesh);
    check_vertices_are_used(mesh);
    check_no_duplicate_cells(mesh);
    check_orientation(mesh);
    check_connection(mesh);
  }
} // namespace springfit
