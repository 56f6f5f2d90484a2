#include <springfit/mesh/boundary_groups.h>
#include <springfit/mesh/facets.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
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

    // The empty list has the id 0.
    void
    give_ids(std::map<Groups, unsigned int> &ids,
             const std::vector<BoundaryGroup> &groups)
    {
      std::set<unsigned int> taken = {0};
      const auto number_of         = [&](const Groups &members) {
        return members.size() == 1 ? groups[members.front()].number : 0;
      };
      for (auto &[members, id] : ids)
        if (taken.insert(number_of(members)).second)
          id = number_of(members);
      unsigned int next = 1;
      for (auto &[members, id] : ids)
        if (id == 0 && !members.empty())
          {
            while (!taken.insert(next).second)
              ++next;
            id = next;
          }
    }

    std::string
    word_of_sides(const MeshDescription &mesh)
    {
      return dimension(mesh.cell_kind) == 2 ? "edges" : "faces";
    }
  } // namespace


  void
  label_boundary_groups(MeshDescription &mesh,
                        const std::vector<BoundaryGroup> &groups)
  {
    const Membership membership(mesh, groups);
    std::vector<Side> boundary = boundary_sides(mesh);
    std::map<Groups, unsigned int> ids;
    std::vector<Groups> groups_of_side;
    for (const Side &side : boundary)
      {
        groups_of_side.push_back(membership.of(side));
        ids.emplace(groups_of_side.back(), 0);
      }
    ids.emplace(Groups(), 0);

    give_ids(ids, groups);
    std::vector<bool> is_used(groups.size(), false);
    mesh.boundary_names.clear();
    for (const auto &[members, id] : ids)
      {
        for (const unsigned int g : members)
          {
            is_used[g] = true;
            mesh.boundary_names.emplace(id, groups[g].name);
          }
      }

    mesh.facets.clear();
    std::size_t n_without = 0;
    for (std::size_t s = 0; s < boundary.size(); ++s)
      {
        const unsigned int id = ids.at(groups_of_side[s]);
        n_without += id == 0 ? 1 : 0;
        mesh.facets.push_back({boundary[s], id});
      }
    if (n_without > 0 && ids.size() > 1)
      mesh.warnings.push_back(mesh.name + ": " + std::to_string(n_without) +
                              " of " + std::to_string(boundary.size()) +
                              " boundary " + word_of_sides(mesh) +
                              " belong to no set; their boundary id is 0.");

    std::sort(boundary.begin(), boundary.end());
    std::vector<bool> is_inside;
    if (std::find(is_used.begin(), is_used.end(), false) != is_used.end())
      is_inside = groups_inside(mesh, membership);
    is_inside.resize(groups.size(), false);
    for (unsigned int g = 0; g < groups.size(); ++g)
      {
        const auto n_inside =
          std::count_if(groups[g].sides.begin(),
                        groups[g].sides.end(),
                        [&](const Side &side) {
                          return !std::binary_search(boundary.begin(),
                                                     boundary.end(),
                                                     side);
                        });
        if (!is_used[g])
          mesh.unused_boundary_names[groups[g].name] =
            n_inside > 0 || is_inside[g]
              ? "lies inside the body"
              : "holds no whole " +
                  std::string(dimension(mesh.cell_kind) == 2 ? "edge"
                                                             : "face") +
                  " of a cell";
        else if (n_inside > 0)
          mesh.warnings.push_back(
            mesh.name + ": " + std::to_string(n_inside) + " of the " +
            std::to_string(groups[g].sides.size()) + ' ' + word_of_sides(mesh) +
            " of '" + groups[g].name +
            "' lie inside the body, not on its boundary, and are left out.");
      }
  }
} // namespace springfit
