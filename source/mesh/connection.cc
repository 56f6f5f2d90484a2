#include <springfit/core/words.h>
#include <springfit/mesh/cell_names.h>
#include <springfit/mesh/conformity.h>
#include <springfit/mesh/connected_parts.h>
#include <springfit/mesh/connection.h>
#include <springfit/mesh/crossed_diagonals.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

namespace springfit
{
  namespace
  {
    /** "x = 0.01, y = 0", in m. */
    std::string
    describe_place(const MeshDescription &mesh, const unsigned int vertex)
    {
      const MeshPoint &point = mesh.vertices[vertex];
      std::ostringstream text;
      text << "x = " << point[0] << ", y = " << point[1];
      if (dimension(mesh.cell_kind) == 3 || point[2] != 0.)
        text << ", z = " << point[2];
      return text.str();
    }

    /** The first ones only, in m. */
    std::string
    describe_places(const MeshDescription &mesh,
                    const std::vector<unsigned int> &vertices)
    {
      constexpr unsigned int n_named = 3;
      std::string text;
      for (unsigned int i = 0; i < vertices.size() && i < n_named; ++i)
        text += (i > 0 ? "; " : "") + describe_place(mesh, vertices[i]);
      return text + (vertices.size() > n_named ? "; ... (m)" : " (m)");
    }

    std::vector<unsigned int>
    part_of_vertices(const MeshDescription &mesh)
    {
      ConnectedParts parts(mesh.vertices.size());
      const int n_corners = n_vertices(mesh.cell_kind);
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (int i = 1; i < n_corners; ++i)
          parts.connect(mesh.cell(c)[0], mesh.cell(c)[i]);
      return parts.part_of_nodes();
    }

    /** One vertex of each position that has vertices of one part, or not. */
    std::vector<unsigned int>
    doubled_places(const MeshDescription &mesh,
                   const std::vector<std::vector<unsigned int>> &doubled,
                   const bool of_one_part)
    {
      if (doubled.empty())
        return {};
      const auto part_of = part_of_vertices(mesh);
      std::vector<unsigned int> places;
      for (const auto &group : doubled)
        if (of_one_part ==
            std::all_of(group.begin(), group.end(), [&](const unsigned int v) {
              return part_of[v] == part_of[group[0]];
            }))
          places.push_back(group[0]);
      return places;
    }

    std::string
    positions(const std::size_t n)
    {
      return std::to_string(n) + (n == 1 ? " position" : " positions");
    }

    const std::string how_to_merge =
      "merge them (in gmsh: 'Coherence Mesh;' in a .geo file that merges the "
      "mesh).";

    std::string
    warning_of_parts(const MeshDescription &mesh,
                     const std::vector<unsigned int> &n_cells,
                     const std::vector<unsigned int> &common_places)
    {
      constexpr unsigned int n_named = 8;
      std::vector<std::string> counts;
      for (unsigned int i = 0; i < n_cells.size() && i < n_named; ++i)
        counts.push_back(std::to_string(n_cells[i]));
      if (n_cells.size() > n_named)
        counts.push_back("...");
      const std::string text =
        mesh.name + " has " + std::to_string(n_cells.size()) +
        " parts without a common vertex, of " + join(counts) + " cells. ";
      if (common_places.empty())
        return text +
               "If they should hold together, mesh them as one body (in gmsh: "
               "Coherence, before meshing); none of their vertices coincide.";
      return text + "They touch with doubled vertices at " +
             positions(common_places.size()) + ": " +
             describe_places(mesh, common_places) +
             ". If they should hold together, " + how_to_merge;
    }

    std::string
    warning_of_doubled_vertices(const MeshDescription &mesh,
                                const std::vector<unsigned int> &places)
    {
      return mesh.name + " has doubled vertices at " +
             positions(places.size()) + ": " + describe_places(mesh, places) +
             ". Cells that touch there are not connected, so that the body "
             "opens or overlaps as at a crack. If this is no crack, " +
             how_to_merge;
    }

    std::string
    warning_of_hanging_vertices(const MeshDescription &mesh,
                                const std::vector<HangingVertex> &hanging)
    {
      std::vector<unsigned int> vertices;
      for (const HangingVertex &found : hanging)
        vertices.push_back(found.vertex);
      return mesh.name + " has " + std::to_string(vertices.size()) +
             (vertices.size() == 1 ? " vertex that hangs"
                                   : " vertices that hang") +
             " in a side of a cell without being its vertex: " +
             describe_places(mesh, vertices) + "; the first one in " +
             describe_cell(mesh, hanging[0].cell) +
             ". Cells that touch there are not connected, so that the body "
             "opens or overlaps. Mesh it anew, so that neighbours share whole "
             "sides: without half-refined cells, and parts as one body.";
    }

    std::string
    warning_of_crossed_diagonals(
      const MeshDescription &mesh,
      const std::vector<std::array<unsigned int, 4>> &crossed)
    {
      std::vector<unsigned int> vertices;
      for (const auto &corners : crossed)
        vertices.push_back(corners[0]);
      return mesh.name + " has " + std::to_string(crossed.size()) +
             (crossed.size() == 1 ? " quadrilateral" : " quadrilaterals") +
             " between cells that the cells on its two sides split by "
             "different diagonals, with a vertex at " +
             describe_places(mesh, vertices) +
             ". Cells that touch there are connected at their vertices only, "
             "so that the body opens or overlaps. Mesh it anew, so that "
             "neighbours share whole sides.";
    }
  } // namespace


  std::vector<unsigned int>
  connected_parts(const MeshDescription &mesh)
  {
    const auto part_of_vertex = part_of_vertices(mesh);
    std::vector<unsigned int> n_cells;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      {
        const unsigned int part = part_of_vertex[mesh.cell(c)[0]];
        if (part >= n_cells.size())
          n_cells.resize(part + 1, 0);
        ++n_cells[part];
      }
    return n_cells;
  }


  void
  check_connection(MeshDescription &mesh)
  {
    const auto parts = connected_parts(mesh);
    const auto found = nonconforming_vertices(mesh);
    if (parts.size() > 1)
      mesh.warnings.push_back(warning_of_parts(
        mesh, parts, doubled_places(mesh, found.doubled, false)));
    if (const auto places = doubled_places(mesh, found.doubled, true);
        !places.empty())
      mesh.warnings.push_back(warning_of_doubled_vertices(mesh, places));
    if (!found.hanging.empty())
      mesh.warnings.push_back(warning_of_hanging_vertices(mesh, found.hanging));
    if (const auto crossed = crossed_diagonals(mesh); !crossed.empty())
      mesh.warnings.push_back(warning_of_crossed_diagonals(mesh, crossed));
  }
} // namespace springfit
