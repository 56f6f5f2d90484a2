#include <springfit/springs/cell_topology.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace springfit
{
  namespace
  {
    using Permutations = std::vector<std::vector<unsigned int>>;

    std::vector<NodePair>
    all_pairs(const unsigned int n)
    {
      std::vector<NodePair> pairs;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = i + 1; j < n; ++j)
          pairs.push_back({{i, j}});
      return pairs;
    }

    /** The vertices that an edge connects with @p vertex, ascending. */
    std::vector<unsigned int>
    edge_neighbours(const CellKind kind, const unsigned int vertex)
    {
      std::vector<unsigned int> neighbours;
      for (int v = 0; v < n_vertices(kind); ++v)
        {
          const unsigned int other = v;
          if (other != vertex &&
              (is_simplex(kind) || edge_axis({{vertex, other}})))
            neighbours.push_back(other);
        }
      return neighbours;
    }

    /** Two edges of a vertex of these cells always have a face in common. */
    std::vector<NodeTriple>
    angles_between_edges(const CellKind kind)
    {
      std::vector<NodeTriple> angles;
      for (int v = 0; v < n_vertices(kind); ++v)
        {
          const unsigned int middle = v;
          const auto ends           = edge_neighbours(kind, middle);
          for (std::size_t a = 0; a < ends.size(); ++a)
            for (std::size_t c = a + 1; c < ends.size(); ++c)
              angles.push_back({{ends[a], middle, ends[c]}});
        }
      return angles;
    }

    Permutations
    all_permutations(const unsigned int n)
    {
      std::vector<unsigned int> permutation(n);
      std::iota(permutation.begin(), permutation.end(), 0);
      Permutations all;
      do
        all.push_back(permutation);
      while (std::next_permutation(permutation.begin(), permutation.end()));
      return all;
    }

    /**
     * The unit cube's symmetries are the permutations of its axes combined
     * with reflections x -> 1 - x of some of them; bit d of a vertex number is
     * the vertex's coordinate d.
     */
    Permutations
    cube_symmetries(const unsigned int dim)
    {
      const unsigned int n_corners = 1u << dim;
      Permutations all;
      for (const auto &axes : all_permutations(dim))
        for (unsigned int mirrored = 0; mirrored < n_corners; ++mirrored)
          {
            std::vector<unsigned int> image(n_corners, 0);
            for (unsigned int v = 0; v < n_corners; ++v)
              for (unsigned int d = 0; d < dim; ++d)
                image[v] |= (((v ^ mirrored) >> d) & 1u) << axes[d];
            all.push_back(image);
          }
      return all;
    }

    /** One table for each type Make, so that it must be a lambda of its own. */
    template <typename Value, typename Make>
    const Value &
    made_once_per_kind(const CellKind kind, const Make &make)
    {
      static const std::map<CellKind, Value> table = [&]() {
        std::map<CellKind, Value> made;
        for (const auto &entry : cell_kind_words())
          made[entry.first] = make(entry.first);
        return made;
      }();
      return table.at(kind);
    }
  } // namespace

  const std::vector<NodePair> &
  node_pairs(const CellKind kind)
  {
    return made_once_per_kind<std::vector<NodePair>>(
      kind, [](const CellKind k) { return all_pairs(n_vertices(k)); });
  }

  const std::vector<NodeTriple> &
  cell_angles(const CellKind kind)
  {
    return made_once_per_kind<std::vector<NodeTriple>>(
      kind, [](const CellKind k) { return angles_between_edges(k); });
  }

  std::optional<int>
  edge_axis(const NodePair &pair)
  {
    // Bit d of a vertex number is its coordinate d.
    for (int axis = 0; axis < 3; ++axis)
      if ((pair[0] ^ pair[1]) == 1u << axis)
        return axis;
    return {};
  }

  const std::vector<std::vector<unsigned int>> &
  symmetries(const CellKind kind)
  {
    return made_once_per_kind<Permutations>(kind, [](const CellKind k) {
      return is_simplex(k) ? all_permutations(n_vertices(k))
                           : cube_symmetries(dimension(k));
    });
  }
} // namespace springfit
