#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/abaqus_file.h>
#include <springfit/mesh/abaqus_model.h>
#include <springfit/mesh/abaqus_sets.h>
#include <springfit/mesh/boundary_groups.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/vertex_order.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace springfit
{
  namespace
  {
    /** Hands over an Abaqus model as a mesh, one thing after the other. */
    class HandOver
    {
    public:
      HandOver(const AbaqusModel &model, const std::string &name, const int dim)
        : model_(model), dim_(dim)
      {
        mesh.name = name;
        for (const std::string &warning : model.warnings)
          mesh.warnings.push_back(name + ": " + warning + '.');
      }

      MeshDescription mesh;

      void
      take_cells()
      {
        check_nodes();
        check_types();
        take_vertices();
        for (unsigned int i = 0; i < model_.instances.size(); ++i)
          {
            std::size_t block = 0;
            for (const AbaqusElement &element : model_.instances[i].elements)
              {
                if (element.type->dim != dim_)
                  continue;
                if (block != element.block)
                  mesh.group_begins.push_back(mesh.n_cells());
                block = element.block;
                mesh.cell_numbers.push_back(element.label);
                cells_.emplace_back(i, &element);
                for (const unsigned int position :
                     order_around_faces(mesh.cell_kind))
                  mesh.cells.push_back(
                    *vertex_of({i, element.nodes[position]}));
              }
          }
        check_no_duplicate_cells(mesh);
      }

      // Sections decide, else the set of the cell's *ELEMENT.
      void
      take_materials()
      {
        std::map<AbaqusItem, std::size_t> section_of_cell; // into groups_
        std::vector<std::string> overlaps;
        std::size_t n_overlaps = 0;
        for (unsigned int i = 0; i < model_.instances.size(); ++i)
          for (const AbaqusSection &section : model_.instances[i].sections)
            {
              if (section.set.empty())
                throw text_error(section.place, "a section names no set");
              const std::size_t group = group_of(section.set, section.material);
              const auto members      = members_of_set(model_,
                                                  AbaqusSetKind::elements,
                                                  i,
                                                  {section.set, section.place});
              for (const AbaqusItem &item : members.items)
                {
                  const auto [old, is_new] =
                    section_of_cell.emplace(item, group);
                  if (is_new || old->second == group)
                    continue;
                  ++n_overlaps;
                  const std::string both =
                    name_of_group(old->second) + " and " + name_of_group(group);
                  if (std::find(overlaps.begin(), overlaps.end(), both) ==
                      overlaps.end())
                    overlaps.push_back(both);
                  old->second = group;
                }
            }
        if (n_overlaps > 0)
          warn(std::to_string(n_overlaps) +
               " elements belong to two sections, " + join_some(overlaps) +
               "; the later one counts.");

        const std::size_t none = -1;
        std::vector<std::size_t> group_of_cell;
        for (const auto &[i, element] : cells_)
          {
            const auto section = section_of_cell.find({i, element->label});
            if (section != section_of_cell.end())
              group_of_cell.push_back(section->second);
            else if (element->set.empty())
              group_of_cell.push_back(none);
            else
              group_of_cell.push_back(
                group_of(name_of_element_set(i, element->set), ""));
          }
        number_materials(group_of_cell, none);
      }

      void
      take_boundaries()
      {
        boundary_ = boundary_sides(mesh);
        std::sort(boundary_.begin(), boundary_.end());
        for (unsigned int i = 0; i < model_.instances.size(); ++i)
          {
            for (const auto &[key, set] : model_.instances[i].node_sets)
              take_node_set(i, set);
            for (const auto &[key, set] : model_.instances[i].element_sets)
              take_element_set(i, set);
            for (const AbaqusSurface &surface : model_.instances[i].surfaces)
              take_surface(i, surface);
          }
        if (!missing_.empty())
          warn("there are sets with members that the file does not define: " +
               join_some(missing_) + "; these are left out.");

        std::vector<BoundaryGroup> groups;
        for (const std::string &key : order_of_boundaries_)
          groups.push_back(boundaries_.at(key));
        label_boundary_groups(mesh, groups);
        for (const std::string &name : sets_of_cells_)
          mesh.unused_boundary_names.emplace(name, "is a set of cells");
      }

    private:
      void
      warn(const std::string &what)
      {
        mesh.warnings.push_back(mesh.name + ": " + what);
      }

      void
      check_nodes() const
      {
        for (const AbaqusInstance &instance : model_.instances)
          for (const AbaqusElement &element : instance.elements)
            for (const std::size_t node : element.nodes)
              if (instance.nodes.count(node) == 0)
                throw text_error(element.place,
                                 "the element " +
                                   std::to_string(element.label) +
                                   " has the node " + std::to_string(node) +
                                   ", which is not defined",
                                 "Define it, or mend the element.");
      }

      void
      check_types()
      {
        std::map<int, std::map<std::string, std::size_t>> n_of_type;
        std::set<const AbaqusElementType *> types;
        for (const AbaqusInstance &instance : model_.instances)
          for (const AbaqusElement &element : instance.elements)
            {
              ++n_of_type[element.type->dim][in_capitals(element.type_name)];
              if (element.type->dim == dim_)
                types.insert(element.type);
            }
        const auto found = [&](const int dim) {
          std::vector<std::string> counts;
          for (const auto &[type, n] : n_of_type[dim])
            counts.push_back(std::to_string(n) + " of type " + type);
          return join_some(counts);
        };

        if (types.empty() || (dim_ == 2 && !n_of_type[3].empty()))
          {
            std::vector<std::string> all;
            for (int d = 1; d <= 3; ++d)
              if (!n_of_type[d].empty())
                all.push_back(found(d) + " of dimension " + std::to_string(d));
            throw InputError(
              mesh.name +
                (types.empty()
                   ? " has no cells of dimension " + std::to_string(dim_)
                   : std::string(
                       " has cells of dimension 3 beside those of 2")) +
                "; it has " +
                (all.empty() ? "no elements at all" : join(all, " and ")) + '.',
              all.empty() ? "Give a complete mesh."
                          : "Set Dimension = " +
                              std::to_string(n_of_type[3].empty() ? 2 : 3) +
                              ", or give another mesh.");
          }
        if (types.size() > 1)
          throw InputError(mesh.name + " has mixed cell types: " + found(dim_) +
                             ".",
                           "Mesh the object with cells of one type.");
        if (!(*types.begin())->cell_kind)
          throw InputError(mesh.name +
                             " has cells that springfit does not know: " +
                             found(dim_) + ".",
                           "Use cells of first order with straight edges: " +
                             join(words_of(cell_kind_words())) + ".");
        mesh.cell_kind = *(*types.begin())->cell_kind;
        for (int d = 1; d < dim_; ++d)
          if (!n_of_type[d].empty())
            warn("beside the cells there are elements of dimension " +
                 std::to_string(d) + ", which are left out: " + found(d) +
                 (d == dim_ - 1
                    ? "; where they lie on the boundary, their sets name it."
                    : "."));
      }

      void
      take_vertices()
      {
        std::size_t n_nodes = 0;
        for (unsigned int i = 0; i < model_.instances.size(); ++i)
          {
            n_nodes += model_.instances[i].nodes.size();
            for (const AbaqusElement &element : model_.instances[i].elements)
              if (element.type->dim == dim_)
                for (const std::size_t node : element.nodes)
                  used_.emplace_back(i, node);
          }
        std::sort(used_.begin(), used_.end());
        used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
        for (const auto &[i, label] : used_)
          mesh.vertices.push_back(model_.instances[i].nodes.at(label));
        if (n_nodes > used_.size())
          mesh.warnings.push_back(
            std::to_string(n_nodes - used_.size()) + " of the " +
            std::to_string(n_nodes) +
            " nodes of the mesh belong to no cell and are left out; the others "
            "are numbered from 0 in the order of their numbers there.");
      }

      std::optional<unsigned int>
      vertex_of(const AbaqusItem &node) const
      {
        const auto place = std::lower_bound(used_.begin(), used_.end(), node);
        if (place == used_.end() || *place != node)
          return {};
        return place - used_.begin();
      }

      // Materials are told apart by the names of their set and material.
      std::size_t
      group_of(const std::string &set, const std::string &material)
      {
        const auto [group, is_new] =
          index_of_group_.emplace(std::make_pair(in_capitals(set),
                                                 in_capitals(material)),
                                  groups_.size());
        if (is_new)
          groups_.emplace_back(set, material);
        return group->second;
      }

      std::string
      name_of_group(const std::size_t group) const
      {
        return "that of '" + groups_[group].first + '\'';
      }

      std::string
      name_of_element_set(const unsigned int instance,
                          const std::string &key) const
      {
        return model_.instances[instance].element_sets.at(key).name;
      }

      void
      number_materials(const std::vector<std::size_t> &group_of_cell,
                       const std::size_t none)
      {
        const std::set<std::size_t> used(group_of_cell.begin(),
                                         group_of_cell.end());
        std::map<std::size_t, unsigned int> ids;
        unsigned int next_id = 1;
        for (const std::size_t group : used)
          if (group != none)
            {
              const auto &[set, material] = groups_[group];
              mesh.material_names.emplace(next_id, set);
              if (!material.empty() &&
                  in_capitals(material) != in_capitals(set))
                mesh.material_names.emplace(next_id, material);
              material_keys_.insert(in_capitals(set));
              material_keys_.insert(in_capitals(material));
              ids[group] = next_id++;
            }
        ids[none] = 0;
        for (const std::size_t group : group_of_cell)
          mesh.material_ids.push_back(ids.at(group));
        const auto n_without =
          std::count(group_of_cell.begin(), group_of_cell.end(), none);
        if (n_without > 0 && !mesh.material_names.empty())
          warn(std::to_string(n_without) +
               " cells belong to no section and no set of *ELEMENT; their "
               "material id is 0.");
      }

      BoundaryGroup &
      boundary(const std::string &name)
      {
        const std::string key = in_capitals(name);
        BoundaryGroup &group  = boundaries_[key];
        if (group.name.empty())
          {
            group.name = name;
            order_of_boundaries_.push_back(key);
          }
        return group;
      }

      // Of several instances, each has its sets by its own name, too.
      std::vector<std::string>
      names_of(const unsigned int instance, const std::string &name) const
      {
        if (instance == 0 || model_.instances.size() <= 2)
          return {name};
        return {name, model_.instances[instance].name + '.' + name};
      }

      void
      note_missing(const std::string &name, const std::size_t n)
      {
        if (n > 0)
          missing_.push_back('\'' + name + "' (" + std::to_string(n) + ')');
      }

      void
      add_vertices(const std::vector<AbaqusItem> &nodes,
                   std::vector<unsigned int> &vertices) const
      {
        for (const AbaqusItem &node : nodes)
          if (const auto vertex = vertex_of(node))
            vertices.push_back(*vertex);
      }

      void
      take_node_set(const unsigned int instance, const AbaqusSet &set)
      {
        const auto members = members_of_set(model_,
                                            AbaqusSetKind::nodes,
                                            instance,
                                            {set.name, {}});
        note_missing(set.name, members.n_missing);
        if (!set.is_internal)
          for (const std::string &name : names_of(instance, set.name))
            add_vertices(members.items, boundary(name).vertices);
      }

      // Sides that are given as elements of their own.
      void
      take_element_set(const unsigned int instance, const AbaqusSet &set)
      {
        const auto members = members_of_set(model_,
                                            AbaqusSetKind::elements,
                                            instance,
                                            {set.name, {}});
        note_missing(set.name, members.n_missing);
        bool has_cells = false;
        for (const AbaqusItem &item : members.items)
          {
            const AbaqusElement &element = element_of(item);
            has_cells = has_cells || element.type->dim == dim_;
            if (element.type->dim == dim_ - 1)
              if (const auto side = side_of(item.first, element.nodes))
                for (const std::string &name : names_of(instance, set.name))
                  boundary(name).sides.push_back(*side);
          }
        if (has_cells)
          {
            sets_of_cells_.insert(set.name);
            if (material_keys_.count(in_capitals(set.name)) == 0)
              mesh.unused_material_names[set.name] =
                "is a set of elements that has no section of its own";
          }
      }

      void
      take_surface(const unsigned int instance, const AbaqusSurface &surface)
      {
        if (surface.is_internal)
          return;
        BoundaryGroup own;
        for (const AbaqusSurface::Item &item : surface.items)
          {
            const auto kind = surface.is_of_nodes ? AbaqusSetKind::nodes
                                                  : AbaqusSetKind::elements;
            const bool is_label =
              std::isdigit(static_cast<unsigned char>(item.what[0]));
            AbaqusMembers members;
            if (is_label)
              members.items = {{instance, read_label(item.what, item.place)}};
            else
              members =
                members_of_set(model_, kind, instance, {item.what, item.place});
            note_missing(surface.name, members.n_missing);
            if (surface.is_of_nodes)
              add_vertices(members.items, own.vertices);
            else
              for (const AbaqusItem &element : members.items)
                add_sides(element, item, own.sides);
          }
        for (const std::string &name : names_of(instance, surface.name))
          {
            BoundaryGroup &group = boundary(name);
            group.vertices.insert(group.vertices.end(),
                                  own.vertices.begin(),
                                  own.vertices.end());
            group.sides.insert(group.sides.end(),
                               own.sides.begin(),
                               own.sides.end());
          }
      }

      const AbaqusElement &
      element_of(const AbaqusItem &item) const
      {
        const AbaqusInstance &home = model_.instances[item.first];
        return home.elements[home.index_of_element.at(item.second)];
      }

      std::optional<std::vector<unsigned int>>
      side_of(const unsigned int instance,
              const std::vector<std::size_t> &nodes) const
      {
        std::vector<unsigned int> side;
        for (const std::size_t node : nodes)
          if (const auto vertex = vertex_of({instance, node}))
            side.push_back(*vertex);
        if (side.size() < nodes.size())
          return {};
        std::sort(side.begin(), side.end());
        return side;
      }

      void
      add_sides(const AbaqusItem &item,
                const AbaqusSurface::Item &from,
                std::vector<std::vector<unsigned int>> &sides) const
      {
        const AbaqusInstance &home = model_.instances[item.first];
        if (home.index_of_element.count(item.second) == 0)
          {
            if (home.shapeless.count(item.second) > 0)
              return;
            throw text_error(from.place,
                             "the element " + std::to_string(item.second) +
                               " is not defined");
          }
        const AbaqusElement &element = element_of(item);
        if (element.type->dim == dim_ - 1)
          {
            if (const auto side = side_of(item.first, element.nodes))
              sides.push_back(*side);
            return;
          }
        if (element.type->dim != dim_)
          return;

        const auto &all = element.type->sides;
        for (std::size_t s = 0; s < all.size(); ++s)
          {
            std::vector<std::size_t> nodes;
            for (const unsigned int position : all[s])
              nodes.push_back(element.nodes[position]);
            const auto side = side_of(item.first, nodes);
            if (from.side.empty() ? std::binary_search(boundary_.begin(),
                                                       boundary_.end(),
                                                       *side)
                                  : number_of_side(from) == s + 1)
              sides.push_back(*side);
          }
        if (!from.side.empty() && number_of_side(from) > all.size())
          throw text_error(from.place,
                           "elements of type " + element.type_name +
                             " have no side '" + from.side + '\'');
      }

      static std::size_t
      number_of_side(const AbaqusSurface::Item &item)
      {
        if (item.side.size() < 2 ||
            std::string("SEP").find(item.side[0]) == std::string::npos)
          throw text_error(item.place,
                           "'" + item.side + "' is no side of a cell",
                           "Sides are S1, S2, ...");
        return read_label(item.side.substr(1), item.place);
      }

      const AbaqusModel &model_;
      const int dim_;
      std::vector<AbaqusItem> used_; // the node of each vertex, ascending
      std::vector<std::pair<unsigned int, const AbaqusElement *>> cells_;

      std::vector<std::pair<std::string, std::string>> groups_;
      std::map<std::pair<std::string, std::string>, std::size_t>
        index_of_group_;
      std::set<std::string> material_keys_;

      std::vector<std::vector<unsigned int>> boundary_; // ascending
      std::map<std::string, BoundaryGroup> boundaries_;
      std::vector<std::string> order_of_boundaries_;
      std::set<std::string> sets_of_cells_;
      std::vector<std::string> missing_;
    };
  } // namespace


  MeshDescription
  read_abaqus_file(const std::filesystem::path &file,
                   const std::string &name,
                   const int dim)
  {
    const AbaqusModel model = make_abaqus_model(read_abaqus_blocks(file));
    HandOver hand_over(model, name, dim);
    hand_over.take_cells();
    hand_over.take_materials();
    hand_over.take_boundaries();
    return std::move(hand_over.mesh);
  }
} // namespace springfit
