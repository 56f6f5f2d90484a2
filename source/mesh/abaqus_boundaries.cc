#include <springfit/mesh/abaqus_boundaries.h>
#include <springfit/mesh/abaqus_sets.h>
#include <springfit/mesh/boundary_groups.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

namespace springfit
{
  namespace
  {
    class Labelling
    {
    public:
      Labelling(const AbaqusModel &model,
                const std::set<std::string> &material_names,
                AbaqusCells &cells)
        : model_(model)
        , material_keys_(material_names)
        , cells_(cells)
        , mesh_(cells.mesh())
      {}

      void
      label()
      {
        boundary_ = boundary_sides(mesh_);
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
        label_boundary_groups(mesh_, groups);
        for (const std::string &name : sets_of_cells_)
          mesh_.unused_boundary_names.emplace(name, "is a set of cells");
      }

    private:
      void
      warn(const std::string &what)
      {
        mesh_.warnings.push_back(mesh_.name + ": " + what);
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
          if (const auto vertex = cells_.vertex_of(node))
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
            has_cells = has_cells || element.type->dim == cells_.dim();
            if (element.type->dim == cells_.dim() - 1)
              if (const auto side = cells_.side_of(item.first, element.nodes))
                for (const std::string &name : names_of(instance, set.name))
                  boundary(name).sides.push_back(*side);
          }
        if (has_cells)
          {
            sets_of_cells_.insert(set.name);
            if (material_keys_.count(in_capitals(set.name)) == 0)
              mesh_.unused_material_names[set.name] =
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
        if (element.type->dim == cells_.dim() - 1)
          {
            if (const auto side = cells_.side_of(item.first, element.nodes))
              sides.push_back(*side);
            return;
          }
        if (element.type->dim != cells_.dim())
          return;

        const auto &all = element.type->sides;
        for (std::size_t s = 0; s < all.size(); ++s)
          {
            std::vector<std::size_t> nodes;
            for (const unsigned int position : all[s])
              nodes.push_back(element.nodes[position]);
            const auto side = cells_.side_of(item.first, nodes);
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
            std::string("SEP").find(item.side[0]) == std::string::npos ||
            !std::isdigit(static_cast<unsigned char>(item.side[1])))
          throw text_error(item.place,
                           "'" + item.side + "' is no side of a cell",
                           "Sides are S1, S2, ..., of shells E1, E2, ...; SPOS "
                           "and SNEG, their faces, are none: remove them.");
        return read_label(item.side.substr(1), item.place);
      }

      const AbaqusModel &model_;
      const std::set<std::string> &material_keys_;
      const AbaqusCells &cells_;
      MeshDescription &mesh_;

      std::vector<std::vector<unsigned int>> boundary_; // ascending
      std::map<std::string, BoundaryGroup> boundaries_;
      std::vector<std::string> order_of_boundaries_;
      std::set<std::string> sets_of_cells_;
      std::vector<std::string> missing_;
    };
  } // namespace


  void
  label_abaqus_boundaries(const AbaqusModel &model,
                          const std::set<std::string> &material_names,
                          AbaqusCells &cells)
  {
    Labelling(model, material_names, cells).label();
  }
} // namespace springfit
