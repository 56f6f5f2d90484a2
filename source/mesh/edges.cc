#include <springfit/mesh/edges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace springfit
{
  std::vector<std::pair<unsigned int, unsigned int>>
  edges_of(const CellKind kind)
  {
    // All pairs of a simplex; in lexicographic order, an edge flips one bit.
    const auto is_edge = [kind](const unsigned int i, const unsigned int j) {
      const unsigned int bits = i ^ j;
      return is_simplex(kind) || bits == 1 || bits == 2 || bits == 4;
    };
    std::vector<std::pair<unsigned int, unsigned int>> edges;
    for (int j = 0; j < n_vertices(kind); ++j)
      for (int i = 0; i < j; ++i)
        if (is_edge(i, j))
          edges.emplace_back(i, j);
    return edges;
  }


  std::vector<double>
  shortest_edges(const MeshDescription &mesh)
  {
    const auto edges = edges_of(mesh.cell_kind);
    std::vector<double> shortest(mesh.vertices.size(),
                                 std::numeric_limits<double>::max());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      for (const auto &[i, j] : edges)
        {
          const unsigned int v = mesh.cell(c)[i], w = mesh.cell(c)[j];
          const MeshPoint &a = mesh.vertices[v], &b = mesh.vertices[w];
          const double length =
            std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
          shortest[v] = std::min(shortest[v], length);
          shortest[w] = std::min(shortest[w], length);
        }
    return shortest;
  }
} // namespace springfit
