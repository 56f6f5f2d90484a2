#include <springfit/mesh/crossed_diagonals.h>
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
    using Edge      = std::pair<unsigned int, unsigned int>; // ascending
    using Neighbors = std::map<Edge, std::set<unsigned int>>;
    using Quadruple = std::array<unsigned int, 4>;

    /** Of each edge of the triangles, the vertices opposite to it. */
    Neighbors
    opposite_vertices(const std::vector<std::vector<unsigned int>> &triangles)
    {
      Neighbors opposite;
      for (std::vector<unsigned int> t : triangles)
        {
          std::sort(t.begin(), t.end());
          opposite[{t[0], t[1]}].insert(t[2]);
          opposite[{t[0], t[2]}].insert(t[1]);
          opposite[{t[1], t[2]}].insert(t[0]);
        }
      return opposite;
    }

    /** Quadruples all of whose triangles are there. */
    std::set<Quadruple>
    closed_quadruples(const Neighbors &opposite)
    {
      std::set<Quadruple> found;
      for (const auto &[edge, vertices] : opposite)
        for (auto first = vertices.begin(); first != vertices.end(); ++first)
          for (auto second = std::next(first); second != vertices.end();
               ++second)
            {
              const auto across = opposite.find({*first, *second});
              if (across == opposite.end() ||
                  across->second.count(edge.first) == 0 ||
                  across->second.count(edge.second) == 0)
                continue;
              Quadruple corners = {{edge.first, edge.second, *first, *second}};
              std::sort(corners.begin(), corners.end());
              found.insert(corners);
            }
      return found;
    }
  } // namespace


  std::vector<std::array<unsigned int, 4>>
  crossed_diagonals(const MeshDescription &mesh)
  {
    if (mesh.cell_kind != CellKind::tetrahedron)
      return {};
    std::set<Quadruple> found =
      closed_quadruples(opposite_vertices(boundary_sides(mesh)));
    for (unsigned int c = 0; c < mesh.n_cells() && !found.empty(); ++c)
      {
        Quadruple corners;
        std::copy_n(mesh.cell(c), 4, corners.begin());
        std::sort(corners.begin(), corners.end());
        found.erase(corners);
      }
    return {found.begin(), found.end()};
  }
} // namespace springfit
