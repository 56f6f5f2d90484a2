#include <springfit/mesh/boundary_groups.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/mesh_text.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace springfit
{
  namespace
  {
    using Side   = std::vector<unsigned int>;
    using Groups = std::vector<unsigned int>; // their indices, ascending

    /** Which groups a side belongs to. */
    class Membership
    {
    public:
      Membership(const MeshDescription &mesh,
                 const std::vector<BoundaryGroup> &groups)
        : of_vertex_(mesh.vertices.size())
      {
        for (unsigned int g = 0; g < groups.size(); ++g)
          {
            for (const unsigned int v : groups[g].vertices)
              if (of_vertex_[v].empty() || of_vertex_[v].back() != g)
                of_vertex_[v].push_back(g);
            for (const Side &side : groups[g].sides)
              listed_.emplace_back(side, g);
          }
        std::sort(listed_.begin(), listed_.end());
      }

      Groups
      by_vertices(const Side &side) const
      {
        Groups common = of_vertex_[side.front()];
        for (const unsigned int v : side)
          {
            Groups rest;
            std::set_intersection(common.begin(),
                                  common.end(),
                                  of_vertex_[v].begin(),
                                  of_vertex_[v].end(),
                                  std::back_inserter(rest));
            common = std::move(rest);
          }
        return common;
      }

      Groups
      of(const Side &side) const
      {
        Groups groups = by_vertices(side);
        for (auto entry = std::lower_bound(listed_.begin(),
                                           listed_.end(),
                                           std::make_pair(side, 0u));
             entry != listed_.end() && entry->first == side;
             ++entry)
          groups.push_back(entry->second);
        std::sort(groups.begin(), groups.end());
        groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
        return groups;
      }

    private:
      std::vector<Groups> of_vertex_;
      std::vector<std::pair<Side, unsigned int>> listed_;
    };

    // The groups whose vertices make up a side of any cell.
    std::vector<bool>
    groups_inside(const MeshDescription &mesh, const Membership &membership)
    {
      std::vector<bool> is_inside;
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (const auto &positions : sides_of(mesh.cell_kind))
          {
            Side side;
            for (const unsigned int position : positions)
              side.push_back(mesh.cell(c)[position]);
            for (const unsigned int g : membership.by_vertices(side))
              {
                is_inside.resize(
                  std::max<std::size_t>(is_inside.size(), g + 1));
                is_inside[g] = true;
              }
          }
      return is_inside;
    }

    using IdOfGroups = std::map<Groups, unsigned int>;

    // The empty list has the id 0.
    void
    give_ids(IdOfGroups &ids, const std::vector<BoundaryGroup> &groups)
    {
      std::set<unsigned int> taken = {0}, given = {0};
      for (const BoundaryGroup &group : groups)
        taken.insert(group.number);
      for (auto &[members, id] : ids)
        if (members.size() == 1 &&
            given.insert(groups[members.front()].number).second)
          id = groups[members.front()].number;
      unsigned int next = 1;
      for (auto &[members, id] : ids)
        if (id == 0 && !members.empty())
          {
            while (!taken.insert(next).second)
              ++next;
            id = next;
          }
    }

    /** The ids of the sides of each group. */
    std::vector<std::set<unsigned int>>
    ids_of_groups(const IdOfGroups &ids, const std::size_t n_groups)
    {
      std::vector<std::set<unsigned int>> result(n_groups);
      for (const auto &[members, id] : ids)
        for (const unsigned int g : members)
          result[g].insert(id);
      return result;
    }

    std::string
    name_or_number(const BoundaryGroup &group)
    {
      return group.name.empty() ? std::to_string(group.number) : group.name;
    }

    void
    name_ids(MeshDescription &mesh,
             const std::vector<BoundaryGroup> &groups,
             const std::vector<std::set<unsigned int>> &ids)
    {
      mesh.boundary_names.clear();
      std::vector<std::string> with_two_meanings;
      for (std::size_t g = 0; g < groups.size(); ++g)
        {
          const unsigned int number = groups[g].number;
          const bool is_its_number  = ids[g] == std::set<unsigned int>{number};
          if (!groups[g].name.empty() || !is_its_number)
            for (const unsigned int id : ids[g])
              mesh.boundary_names.emplace(id, name_or_number(groups[g]));
          if (!groups[g].name.empty() && number > 0 && ids[g].size() > 1)
            with_two_meanings.push_back(std::to_string(number) + " ('" +
                                        groups[g].name + "')");
        }
      if (!with_two_meanings.empty())
        mesh.warnings.push_back(
          mesh.name +
          ": there are groups of the boundary that overlap. Sides of several "
          "have an id of their own and all names; the numbers " +
          join_some(with_two_meanings) +
          " mean the sides of one group only, the names all of its sides.");
    }

    std::string
    word_of_sides(const MeshDescription &mesh)
    {
      return dimension(mesh.cell_kind) == 2 ? "edges" : "faces";
    }

    // @p is_used tells which have sides on the boundary.
    void
    note_sides_elsewhere(MeshDescription &mesh,
                         const std::vector<BoundaryGroup> &groups,
                         const Membership &membership,
                         std::vector<Side> boundary,
                         const std::vector<bool> &is_used)
    {
      std::sort(boundary.begin(), boundary.end());
      std::vector<bool> is_inside;
      if (std::find(is_used.begin(), is_used.end(), false) != is_used.end())
        is_inside = groups_inside(mesh, membership);
      is_inside.resize(groups.size(), false);
      const std::string where = "inside the body or on no cell";
      std::vector<std::string> counts;
      for (unsigned int g = 0; g < groups.size(); ++g)
        {
          const BoundaryGroup &group = groups[g];
          const std::size_t n_elsewhere =
            group.n_sides_without_cell +
            std::count_if(group.sides.begin(),
                          group.sides.end(),
                          [&](const Side &side) {
                            return !std::binary_search(boundary.begin(),
                                                       boundary.end(),
                                                       side);
                          });
          if (!is_used[g])
            mesh.unused_boundary_names[name_or_number(group)] =
              n_elsewhere > 0 || is_inside[g]
                ? "lies " + where
                : "holds no whole " +
                    std::string(dimension(mesh.cell_kind) == 2 ? "edge"
                                                               : "face") +
                    " of a cell";
          if (n_elsewhere > 0)
            counts.push_back(std::to_string(n_elsewhere) + " of '" +
                             name_or_number(group) + '\'');
        }
      if (!counts.empty())
        mesh.warnings.push_back(
          mesh.name + ": " + word_of_sides(mesh) + " that lie " + where +
          ", not on the boundary, are left out: " + join_some(counts) + '.');
    }
  } // namespace


  void
  label_boundary_groups(MeshDescription &mesh,
                        const std::vector<BoundaryGroup> &groups)
  {
    const Membership membership(mesh, groups);
    const std::vector<Side> boundary = boundary_sides(mesh);
    IdOfGroups id_of_groups          = {{Groups(), 0}};
    std::vector<Groups> groups_of_side;
    for (const Side &side : boundary)
      {
        groups_of_side.push_back(membership.of(side));
        id_of_groups.emplace(groups_of_side.back(), 0);
      }
    give_ids(id_of_groups, groups);
    const auto ids = ids_of_groups(id_of_groups, groups.size());
    name_ids(mesh, groups, ids);

    mesh.facets.clear();
    std::size_t n_without = 0;
    for (std::size_t s = 0; s < boundary.size(); ++s)
      {
        const unsigned int id = id_of_groups.at(groups_of_side[s]);
        n_without += id == 0 ? 1 : 0;
        mesh.facets.push_back({boundary[s], id});
      }
    if (n_without > 0 && !groups.empty())
      mesh.warnings.push_back(mesh.name + ": " + std::to_string(n_without) +
                              " of " + std::to_string(boundary.size()) +
                              " boundary " + word_of_sides(mesh) +
                              " belong to no group; their boundary id is 0.");

    std::vector<bool> is_used;
    for (const auto &ids_of_group : ids)
      is_used.push_back(!ids_of_group.empty());
    note_sides_elsewhere(mesh, groups, membership, boundary, is_used);
  }
} // namespace springfit
