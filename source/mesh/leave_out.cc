#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/leave_out.h>
#include <springfit/mesh/name_lookup.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace springfit
{
  namespace
  {
    const std::string entry = "Geometry/Leave out";

    std::set<unsigned int>
    ids_of(const MeshDescription &mesh,
           const std::vector<std::string> &materials)
    {
      const std::set<unsigned int> known(mesh.material_ids.begin(),
                                         mesh.material_ids.end());
      std::set<unsigned int> ids;
      for (const auto &word : materials)
        ids.merge(find_ids(ids_and_names(known, mesh.material_names),
                           mesh.unused_material_names,
                           word,
                           "material",
                           entry));
      if (ids == known)
        throw EntryError(entry, "no cell is left.", "Name fewer materials.");
      return ids;
    }

    /** "material 3 (bone)" */
    std::string
    name_of(const MeshDescription &mesh, const unsigned int id)
    {
      const auto names = joined_names(mesh.material_names, id);
      return "material " + std::to_string(id) +
             (names.empty() ? "" : " (" + names + ')');
    }

    using Vertices = std::vector<unsigned int>; // ascending

    Vertices
    ascending(Vertices vertices)
    {
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    }

    std::vector<Vertices>
    sides_of_cell(const MeshDescription &mesh, const unsigned int cell)
    {
      std::vector<Vertices> sides;
      for (const auto &positions : sides_of(mesh.cell_kind))
        {
          sides.emplace_back();
          for (const unsigned int i : positions)
            sides.back().push_back(mesh.cell(cell)[i]);
          sides.back() = ascending(sides.back());
        }
      return sides;
    }

    /**
     * Where cells that go meet cells that stay: the material of the former for
     * each side.
     */
    std::map<Vertices, unsigned int>
    interface(const MeshDescription &mesh, const std::set<unsigned int> &ids)
    {
      std::map<Vertices, unsigned int> going, both;
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        if (ids.count(mesh.material_ids[c]) > 0)
          for (auto &side : sides_of_cell(mesh, c))
            going.emplace(std::move(side), mesh.material_ids[c]);
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        if (ids.count(mesh.material_ids[c]) == 0)
          for (const auto &side : sides_of_cell(mesh, c))
            if (const auto found = going.find(side); found != going.end())
              both.insert(*found);
      return both;
    }

    /** A boundary on each interface, where the mesh has none. */
    void
    add_boundaries(MeshDescription &mesh, const std::set<unsigned int> &ids)
    {
      std::set<Vertices> known;
      unsigned int free_id = 1;
      for (const auto &facet : mesh.facets)
        {
          known.insert(ascending(facet.vertices));
          free_id = std::max(free_id, facet.id + 1);
        }
      for (const auto &[id, name] : mesh.boundary_names)
        free_id = std::max(free_id, id + 1);

      std::map<unsigned int, unsigned int> boundary_of;
      for (const auto &[side, material] : interface(mesh, ids))
        if (known.count(side) == 0)
          {
            if (boundary_of.try_emplace(material, free_id).second)
              {
                const auto [begin, end] =
                  mesh.material_names.equal_range(material);
                for (auto name = begin; name != end; ++name)
                  mesh.boundary_names.emplace(free_id, name->second);
                if (begin == end)
                  mesh.boundary_names.emplace(free_id,
                                              "left out " +
                                                std::to_string(material));
                ++free_id;
              }
            mesh.facets.push_back({side, boundary_of.at(material)});
          }
    }

    void
    remove_cells(MeshDescription &mesh, const std::set<unsigned int> &ids)
    {
      const unsigned int n = n_vertices(mesh.cell_kind);
      MeshDescription rest = mesh;
      rest.cells.clear();
      rest.material_ids.clear();
      rest.cell_numbers.clear();
      rest.group_begins.clear();
      auto group = mesh.group_begins.begin();
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        {
          // A group that went whole begins where the next one does.
          for (; group != mesh.group_begins.end() && *group == c; ++group)
            if (rest.group_begins.empty() ||
                rest.group_begins.back() != rest.n_cells())
              rest.group_begins.push_back(rest.n_cells());
          if (ids.count(mesh.material_ids[c]) > 0)
            continue;
          rest.cells.insert(rest.cells.end(), mesh.cell(c), mesh.cell(c) + n);
          rest.material_ids.push_back(mesh.material_ids[c]);
          if (!mesh.cell_numbers.empty())
            rest.cell_numbers.push_back(mesh.cell_numbers[c]);
        }
      if (!rest.group_begins.empty() &&
          rest.group_begins.back() == rest.n_cells())
        rest.group_begins.pop_back();
      mesh = std::move(rest);
    }

    /** Those of which no cell that is left has any. */
    void
    remove_facets(MeshDescription &mesh)
    {
      std::set<Vertices> sides;
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (auto &side : sides_of_cell(mesh, c))
          sides.insert(std::move(side));
      mesh.facets.erase(std::remove_if(mesh.facets.begin(),
                                       mesh.facets.end(),
                                       [&](const BoundaryFacet &facet) {
                                         return sides.count(ascending(
                                                  facet.vertices)) == 0;
                                       }),
                        mesh.facets.end());
    }

    /** Those that only cells of @p before had. */
    void
    remove_vertices(MeshDescription &mesh,
                    const std::vector<unsigned int> &before)
    {
      std::vector<bool> had(mesh.vertices.size(), false), has = had;
      for (const unsigned int v : before)
        had.at(v) = true;
      for (const unsigned int v : mesh.cells)
        has[v] = true;

      std::vector<unsigned int> new_number(mesh.vertices.size());
      std::vector<MeshPoint> vertices;
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (has[v] || !had[v])
          {
            new_number[v] = vertices.size();
            vertices.push_back(mesh.vertices[v]);
          }
      mesh.vertices = std::move(vertices);
      for (auto &v : mesh.cells)
        v = new_number[v];
      for (auto &facet : mesh.facets)
        for (auto &v : facet.vertices)
          v = new_number[v];
    }
  } // namespace


  void
  leave_out(MeshDescription &mesh, const std::vector<std::string> &materials)
  {
    const auto ids                        = ids_of(mesh, materials);
    const unsigned int n_before           = mesh.n_cells();
    const std::vector<unsigned int> cells = mesh.cells;
    add_boundaries(mesh, ids);
    remove_cells(mesh, ids);
    remove_facets(mesh);
    remove_vertices(mesh, cells);

    std::vector<std::string> words;
    for (const unsigned int id : ids)
      {
        words.push_back(name_of(mesh, id));
        const auto [begin, end] = mesh.material_names.equal_range(id);
        for (auto name = begin; name != end; ++name)
          mesh.unused_material_names.emplace(name->second,
                                             "is left out by 'Leave out' in "
                                             "section Geometry");
        mesh.material_names.erase(begin, end);
      }
    mesh.left_out = std::to_string(n_before - mesh.n_cells()) + " of " +
                    std::to_string(n_before) + " cells, " + join(words);
  }
} // namespace springfit
