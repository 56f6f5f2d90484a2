#include <springfit/mesh/abaqus_materials.h>
#include <springfit/mesh/abaqus_sets.h>
#include <springfit/mesh/mesh_text.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    class Labelling
    {
    public:
      Labelling(const AbaqusModel &model, AbaqusCells &cells)
        : model_(model), cells_(cells), mesh_(cells.mesh())
      {}

      // Sections decide, else the set of the cell's *ELEMENT.
      /** The names in capitals. */
      std::set<std::string>
      label()
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
        for (const auto &[i, element] : cells_.elements())
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
        if (section_of_cell.empty())
          name_by_sets();
        return material_keys_;
      }

    private:
      void
      warn(const std::string &what)
      {
        mesh_.warnings.push_back(mesh_.name + ": " + what);
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
              mesh_.material_names.emplace(next_id, set);
              if (!material.empty() &&
                  in_capitals(material) != in_capitals(set))
                mesh_.material_names.emplace(next_id, material);
              material_keys_.insert(in_capitals(set));
              material_keys_.insert(in_capitals(material));
              ids[group] = next_id++;
            }
        ids[none] = 0;
        mesh_.material_ids.clear();
        for (const std::size_t group : group_of_cell)
          mesh_.material_ids.push_back(ids.at(group));
        const auto n_without =
          std::count(group_of_cell.begin(), group_of_cell.end(), none);
        if (n_without > 0 && !mesh_.material_names.empty())
          warn(std::to_string(n_without) +
               " cells belong to no section and no set of *ELEMENT; their "
               "material id is 0.");
      }

      // Without sections a set that has all cells of some materials is a name
      // of them: so gmsh writes its physical groups.
      void
      name_by_sets()
      {
        std::map<AbaqusItem, unsigned int> id_of_cell;
        std::map<unsigned int, std::size_t> n_cells; // of each id
        for (std::size_t c = 0; c < cells_.elements().size(); ++c)
          {
            const auto &[i, element]        = cells_.elements()[c];
            id_of_cell[{i, element->label}] = mesh_.material_ids[c];
            ++n_cells[mesh_.material_ids[c]];
          }
        for (unsigned int i = 0; i < model_.instances.size(); ++i)
          for (const auto &[key, set] : model_.instances[i].element_sets)
            {
              if (set.is_internal ||
                  material_keys_.count(in_capitals(set.name)) > 0)
                continue;
              const auto members = members_of_set(model_,
                                                  AbaqusSetKind::elements,
                                                  i,
                                                  {set.name, {}});
              std::map<unsigned int, std::size_t> n_members;
              for (const AbaqusItem &item :
                   std::set<AbaqusItem>(members.items.begin(),
                                        members.items.end()))
                if (const auto cell = id_of_cell.find(item);
                    cell != id_of_cell.end())
                  ++n_members[cell->second];
              const bool is_whole =
                std::all_of(n_members.begin(),
                            n_members.end(),
                            [&](const auto &of_id) {
                              return of_id.second == n_cells[of_id.first];
                            });
              // One of all materials tells nothing apart.
              if (n_members.empty() || !is_whole ||
                  (n_members.size() == n_cells.size() && n_cells.size() > 1))
                continue;
              for (const auto &of_id : n_members)
                mesh_.material_names.emplace(of_id.first, set.name);
              material_keys_.insert(in_capitals(set.name));
            }
      }

      const AbaqusModel &model_;
      const AbaqusCells &cells_;
      MeshDescription &mesh_;
      std::vector<std::pair<std::string, std::string>> groups_;
      std::map<std::pair<std::string, std::string>, std::size_t>
        index_of_group_;
      std::set<std::string> material_keys_;
    };
  } // namespace


  std::set<std::string>
  label_abaqus_materials(const AbaqusModel &model, AbaqusCells &cells)
  {
    return Labelling(model, cells).label();
  }
} // namespace springfit
