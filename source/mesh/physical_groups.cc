#include <springfit/core/words.h>
#include <springfit/mesh/boundary_groups.h>
#include <springfit/mesh/msh_head.h>
#include <springfit/mesh/physical_groups.h>

#include <gmsh.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace springfit
{
  namespace
  {
    constexpr const char *switch_tags = "Mesh.SwitchElementTags";

    // Tells whether the entities' numbers are the physical ones.
    bool
    tags_are_switched()
    {
      double switched;
      gmsh::option::getNumber(switch_tags, switched);
      return switched > 0.;
    }

    bool
    has_elements(const int dim, const int entity)
    {
      std::vector<int> types;
      std::vector<std::vector<std::size_t>> numbers, nodes;
      gmsh::model::mesh::getElements(types, numbers, nodes, dim, entity);
      return std::any_of(numbers.begin(), numbers.end(), [](const auto &of) {
        return !of.empty();
      });
    }

    std::vector<int>
    entities_with_elements(const int dim)
    {
      gmsh::vectorpair entities;
      gmsh::model::getEntities(entities, dim);
      std::vector<int> result;
      for (const auto &[entity_dim, entity] : entities)
        if (has_elements(dim, entity))
          result.push_back(entity);
      return result;
    }

    /** Ascending; gmsh's signs, which tell orientations, are dropped. */
    std::set<unsigned int>
    physical_ids(const int dim, const int entity)
    {
      if (tags_are_switched())
        return entity > 0 ? std::set<unsigned int>{unsigned(entity)}
                          : std::set<unsigned int>{};
      std::vector<int> tags;
      gmsh::model::getPhysicalGroupsForEntity(dim, entity, tags);
      std::set<unsigned int> ids;
      for (const int tag : tags)
        ids.insert(std::abs(tag));
      return ids;
    }

    bool
    has_ambiguous_groups(const int dim)
    {
      for (const int d : {dim - 1, dim})
        for (const int entity : entities_with_elements(d))
          if (physical_ids(d, entity).size() > 1)
            return true;
      return false;
    }

    bool
    states_groups_by_element(const std::filesystem::path &file)
    {
      const std::string version = read_msh_head(file).version;
      return version.substr(0, 1) == "1" || version.substr(0, 1) == "2";
    }

    /** By their dimension and number, without sign. */
    using GroupNames = std::map<std::pair<int, unsigned int>, std::string>;

    /** The dimension and number of each group that has elements. */
    std::set<std::pair<int, unsigned int>>
    groups_with_elements()
    {
      std::set<std::pair<int, unsigned int>> groups;
      for (int dim = 0; dim <= 3; ++dim)
        for (const int entity : entities_with_elements(dim))
          for (const unsigned int id : physical_ids(dim, entity))
            groups.emplace(dim, id);
      return groups;
    }

    GroupNames
    names_of_groups(const std::vector<MshName> &in_file)
    {
      const auto groups = groups_with_elements();
      GroupNames names;
      for (const auto &[dim, id] : groups)
        for (const int number : {static_cast<int>(id), -static_cast<int>(id)})
          {
            std::string name;
            gmsh::model::getPhysicalName(dim, number, name);
            if (!name.empty())
              names.emplace(std::make_pair(dim, id), name);
          }
      for (const auto &[dim, number, name] : in_file)
        if (groups.count({dim, std::abs(number)}) > 0)
          names.emplace(std::make_pair(dim, std::abs(number)), name);
      return names;
    }

    std::string
    word_of_dimension(const int dim)
    {
      return dim == 1 ? "curve" : dim == 2 ? "surface" : "volume";
    }

    /** The ids of each entity of dimension @p dim that has elements. */
    struct Ids
    {
      std::map<int, std::set<unsigned int>> of_entity; // may be empty
      bool are_physical; // else gmsh's own numbers
    };

    Ids
    entity_ids(const int dim, MeshDescription &mesh)
    {
      const auto entities = entities_with_elements(dim);
      Ids ids;
      for (const int entity : entities)
        ids.of_entity[entity] = physical_ids(dim, entity);
      ids.are_physical = std::any_of(ids.of_entity.begin(),
                                     ids.of_entity.end(),
                                     [](const auto &of_entity) {
                                       return !of_entity.second.empty();
                                     });
      if (ids.are_physical || entities.size() < 2)
        return ids;
      for (const int entity : entities)
        ids.of_entity[entity] = {unsigned(std::abs(entity))};
      mesh.warnings.push_back(
        mesh.name + " has no physical groups of " + word_of_dimension(dim) +
        "s; the numbers of its " + word_of_dimension(dim) + "s serve as ids.");
      return ids;
    }

    // Sides of @p entity whose vertices all belong to cells, and how many
    // others it has.
    void
    add_sides(BoundaryGroup &group, const GmshCells &cells, const int entity)
    {
      const int dim = dimension(cells.mesh.cell_kind) - 1;
      std::vector<int> types;
      std::vector<std::vector<std::size_t>> numbers, nodes;
      gmsh::model::mesh::getElements(types, numbers, nodes, dim, entity);
      for (unsigned int t = 0; t < types.size(); ++t)
        {
          const std::size_t n =
            numbers[t].empty() ? 0 : nodes[t].size() / numbers[t].size();
          for (std::size_t e = 0; e < numbers[t].size(); ++e)
            {
              std::vector<unsigned int> side;
              for (std::size_t i = 0; i < n; ++i)
                {
                  const auto vertex =
                    cells.vertex_of_node.find(nodes[t][e * n + i]);
                  if (vertex != cells.vertex_of_node.end())
                    side.push_back(vertex->second);
                }
              std::sort(side.begin(), side.end());
              if (side.size() == n)
                group.sides.push_back(side);
              else
                ++group.n_sides_without_cell;
            }
        }
    }

    void
    note_other_groups(MeshDescription &mesh, const GroupNames &names)
    {
      const int dim = dimension(mesh.cell_kind);
      for (const auto &[group, name] : names)
        {
          const int group_dim = group.first;
          if (group_dim == dim)
            mesh.unused_boundary_names.emplace(name, "is a group of cells");
          else
            mesh.unused_material_names.emplace(name, "is no group of cells");
          if (group_dim < dim - 1)
            mesh.unused_boundary_names.emplace(name,
                                               "is of dimension " +
                                                 std::to_string(group_dim));
        }
    }

    /** The id of the material of an entity; cells have one of several. */
    unsigned int
    material_id(const int entity,
                const std::set<unsigned int> &ids,
                MeshDescription &mesh)
    {
      if (ids.size() > 1)
        {
          std::vector<std::string> all;
          for (const unsigned int id : ids)
            all.push_back(std::to_string(id));
          mesh.warnings.push_back(
            mesh.name + ": " + word_of_dimension(dimension(mesh.cell_kind)) +
            ' ' + std::to_string(entity) + " belongs to the physical groups " +
            join(all) + "; it is taken for " + all.front() + ".");
        }
      return ids.empty() ? 0 : *ids.begin();
    }
  } // namespace


  void
  open_with_groups(const std::filesystem::path &file, const int dim)
  {
    gmsh::open(file.string());
    if (has_ambiguous_groups(dim) && states_groups_by_element(file))
      {
        gmsh::clear();
        gmsh::option::setNumber(switch_tags, 1);
        gmsh::open(file.string());
      }
  }


  void
  read_materials(GmshCells &cells, const std::vector<MshName> &names)
  {
    MeshDescription &mesh = cells.mesh;
    const int dim         = dimension(mesh.cell_kind);
    const Ids ids         = entity_ids(dim, mesh);
    std::map<int, unsigned int> id_of_entity;
    for (const auto &[entity, of_entity] : ids.of_entity)
      id_of_entity[entity] = material_id(entity, of_entity, mesh);

    std::set<unsigned int> found;
    unsigned int n_without = 0;
    for (unsigned int g = 0; g < mesh.group_begins.size(); ++g)
      {
        const auto id          = id_of_entity.at(cells.entities[g]);
        const unsigned int end = g + 1 < mesh.group_begins.size()
                                   ? mesh.group_begins[g + 1]
                                   : mesh.n_cells();
        std::fill(mesh.material_ids.begin() + mesh.group_begins[g],
                  mesh.material_ids.begin() + end,
                  id);
        found.insert(id);
        n_without += id == 0 ? end - mesh.group_begins[g] : 0;
      }
    for (const auto &[group, name] : names_of_groups(names))
      if (group.first == dim && found.count(group.second) > 0)
        mesh.material_names.emplace(group.second, name);
      else if (group.first == dim)
        mesh.unused_material_names[name] =
          "holds only cells of groups with a lower number";
    if (ids.are_physical && n_without > 0)
      mesh.warnings.push_back(mesh.name + ": " + std::to_string(n_without) +
                              " cells belong to no physical " +
                              word_of_dimension(dim) +
                              "; their material id is 0.");
  }


  void
  read_boundaries(GmshCells &cells, const std::vector<MshName> &names)
  {
    MeshDescription &mesh = cells.mesh;
    const int dim         = dimension(mesh.cell_kind) - 1;
    const auto all_names  = names_of_groups(names);
    std::map<unsigned int, BoundaryGroup> groups;
    for (const auto &[entity, ids] : entity_ids(dim, mesh).of_entity)
      for (const unsigned int id : ids)
        add_sides(groups[id], cells, entity);

    std::vector<BoundaryGroup> all;
    for (auto &[id, group] : groups)
      {
        const auto name = all_names.find({dim, id});
        group.number    = id;
        group.name      = name == all_names.end() ? "" : name->second;
        all.push_back(std::move(group));
      }
    label_boundary_groups(mesh, all);
    note_other_groups(mesh, all_names);
  }
} // namespace springfit
