#include <springfit/mesh/facets.h>
#include <springfit/mesh/physical_groups.h>

#include <gmsh.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <string>

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
      std::ifstream stream(file);
      std::string first, version;
      stream >> first >> version;
      return first == "$NOD" ||
             (first == "$MeshFormat" && version.substr(0, 1) == "2");
    }

    std::string
    word_of_dimension(const int dim)
    {
      return dim == 1 ? "curve" : dim == 2 ? "surface" : "volume";
    }

    /** The id of each entity of dimension @p dim that has elements. */
    struct Ids
    {
      std::map<int, unsigned int> of_entity;
      bool are_physical; // else gmsh's own numbers
    };

    Ids
    entity_ids(const int dim, MeshDescription &mesh)
    {
      const auto entities = entities_with_elements(dim);
      Ids ids;
      ids.are_physical =
        std::any_of(entities.begin(), entities.end(), [&](const int entity) {
          return !physical_ids(dim, entity).empty();
        });
      for (const int entity : entities)
        {
          const auto physical = physical_ids(dim, entity);
          if (!physical.empty())
            ids.of_entity[entity] = *physical.begin();
          else if (ids.are_physical || entities.size() < 2)
            ids.of_entity[entity] = 0;
          else
            ids.of_entity[entity] = std::abs(entity);

          if (physical.size() > 1)
            {
              std::vector<std::string> all;
              for (const unsigned int id : physical)
                all.push_back(std::to_string(id));
              mesh.warnings.push_back(
                mesh.name + ": " + word_of_dimension(dim) + ' ' +
                std::to_string(entity) + " belongs to the physical groups " +
                join(all) + "; it is taken for " + all.front() + ".");
            }
        }
      if (!ids.are_physical && entities.size() > 1)
        mesh.warnings.push_back(mesh.name + " has no physical groups of " +
                                word_of_dimension(dim) +
                                "s; the numbers of its " +
                                word_of_dimension(dim) + "s serve as ids.");
      return ids;
    }

    using IdOfSide = std::map<std::vector<unsigned int>, unsigned int>;

    // Sides by their vertices in ascending order; those with a vertex that no
    // cell has are left out. Of several ids of a side, the lowest counts.
    void
    add_sides(IdOfSide &id_of_side,
              const GmshCells &cells,
              const int entity,
              const unsigned int id,
              unsigned int &n_ambiguous)
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
              if (side.size() < n)
                continue;
              std::sort(side.begin(), side.end());
              const auto [old, is_new] = id_of_side.emplace(side, id);
              if (!is_new && old->second != id)
                {
                  old->second = std::min(old->second, id);
                  ++n_ambiguous;
                }
            }
        }
    }

    std::string
    name_of_group(const int dim, const int tag)
    {
      std::string name;
      gmsh::model::getPhysicalName(dim, tag, name);
      return name.empty() ? std::to_string(std::abs(tag)) : name;
    }

    // @p rest are the sides that are not on the boundary, @p found the ids that
    // are.
    void
    note_sides_elsewhere(const IdOfSide &rest,
                         const std::set<unsigned int> &found,
                         MeshDescription &mesh)
    {
      const int dim = dimension(mesh.cell_kind) - 1;
      std::map<unsigned int, std::size_t> n_elsewhere;
      for (const auto &[side, id] : rest)
        ++n_elsewhere[id];
      gmsh::vectorpair groups;
      gmsh::model::getPhysicalGroups(groups, dim);
      for (const auto &[group_dim, tag] : groups)
        {
          const unsigned int id   = std::abs(tag);
          const std::string name  = name_of_group(dim, tag);
          const bool is_elsewhere = n_elsewhere.count(id) > 0;
          if (found.count(id) == 0)
            mesh.unused_boundary_names[name] =
              is_elsewhere ? "lies inside the body or on no cell"
                           : "holds no side of a cell";
          else if (is_elsewhere)
            mesh.warnings.push_back(
              mesh.name + ": " + std::to_string(n_elsewhere.at(id)) +
              (dim == 1 ? " edges" : " faces") + " of '" + name +
              "' lie inside the body or on no cell, not on the boundary, and "
              "are left out.");
        }
    }

    void
    note_other_groups(MeshDescription &mesh)
    {
      const int dim = dimension(mesh.cell_kind);
      gmsh::vectorpair groups;
      gmsh::model::getPhysicalGroups(groups);
      for (const auto &[group_dim, tag] : groups)
        {
          std::string name;
          gmsh::model::getPhysicalName(group_dim, tag, name);
          if (name.empty())
            continue;
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

    // gmsh gives a reversed group the negative of its number.
    std::multimap<unsigned int, std::string>
    names_of_ids(const int dim, const std::set<unsigned int> &ids)
    {
      std::multimap<unsigned int, std::string> names;
      for (const unsigned int id : ids)
        for (const int tag : {-static_cast<int>(id), static_cast<int>(id)})
          {
            std::string name;
            gmsh::model::getPhysicalName(dim, tag, name);
            if (!name.empty())
              names.emplace(id, name);
          }
      return names;
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
  read_materials(GmshCells &cells)
  {
    MeshDescription &mesh = cells.mesh;
    const int dim         = dimension(mesh.cell_kind);
    const Ids ids         = entity_ids(dim, mesh);
    std::set<unsigned int> found;
    unsigned int n_without = 0;
    for (unsigned int g = 0; g < mesh.group_begins.size(); ++g)
      {
        const auto id          = ids.of_entity.at(cells.entities[g]);
        const unsigned int end = g + 1 < mesh.group_begins.size()
                                   ? mesh.group_begins[g + 1]
                                   : mesh.n_cells();
        std::fill(mesh.material_ids.begin() + mesh.group_begins[g],
                  mesh.material_ids.begin() + end,
                  id);
        found.insert(id);
        n_without += id == 0 ? end - mesh.group_begins[g] : 0;
      }
    if (ids.are_physical)
      mesh.material_names = names_of_ids(dim, found);
    if (ids.are_physical && n_without > 0)
      mesh.warnings.push_back(mesh.name + ": " + std::to_string(n_without) +
                              " cells belong to no physical " +
                              word_of_dimension(dim) +
                              "; their material id is 0.");
  }


  void
  read_boundaries(GmshCells &cells)
  {
    MeshDescription &mesh = cells.mesh;
    const int dim         = dimension(mesh.cell_kind) - 1;
    const Ids ids         = entity_ids(dim, mesh);
    IdOfSide id_of_side;
    unsigned int n_ambiguous = 0;
    for (const auto &[entity, id] : ids.of_entity)
      if (id > 0)
        add_sides(id_of_side, cells, entity, id, n_ambiguous);

    std::set<unsigned int> found;
    unsigned int n_without = 0;
    mesh.facets.clear();
    for (auto &side : boundary_sides(mesh))
      {
        const auto known = id_of_side.find(side);
        const auto id    = known == id_of_side.end() ? 0 : known->second;
        if (known != id_of_side.end())
          id_of_side.erase(known);
        found.insert(id);
        n_without += id == 0 ? 1 : 0;
        mesh.facets.push_back({std::move(side), id});
      }

    if (ids.are_physical)
      {
        mesh.boundary_names = names_of_ids(dim, found);
        note_sides_elsewhere(id_of_side, found, mesh);
      }
    note_other_groups(mesh);
    if (n_ambiguous > 0)
      mesh.warnings.push_back(mesh.name + ": " + std::to_string(n_ambiguous) +
                              " sides belong to several physical " +
                              word_of_dimension(dim) +
                              "s; the lowest number counts.");
    if (n_without > 0)
      mesh.warnings.push_back(
        mesh.name + ": " + std::to_string(n_without) + " of " +
        std::to_string(mesh.facets.size()) + " boundary " +
        (dim == 1 ? "edges" : "faces") + " belong to no physical " +
        word_of_dimension(dim) + "; their boundary id is 0.");
  }
} // namespace springfit
