#include <springfit/fit/cell/regularity.h>
#include <springfit/springs/cell_topology.h>

#include <algorithm>
#include <limits>
#include <map>

namespace springfit
{
  namespace
  {
    /** Whether the distances of vertices of the same group are equal. */
    template <typename Group>
    bool
    lengths_agree(const Eigen::MatrixXd &points,
                  const CellKind kind,
                  const Group &group_of)
    {
      struct Range
      {
        double smallest = std::numeric_limits<double>::max();
        double largest  = 0.;
      };
      std::map<int, Range> ranges;
      for (const auto &pair : node_pairs(kind))
        {
          const double length =
            (points.col(pair[1]) - points.col(pair[0])).norm();
          auto &range    = ranges[group_of(pair)];
          range.smallest = std::min(range.smallest, length);
          range.largest  = std::max(range.largest, length);
        }
      return std::all_of(ranges.begin(), ranges.end(), [](const auto &entry) {
        return entry.second.largest <= 1.01 * entry.second.smallest;
      });
    }
  } // namespace


  bool
  is_regular(const Eigen::MatrixXd &points, const CellKind kind)
  {
    // In how many coordinates the vertices of the unit cube differ tells
    // edges, diagonals of faces and diagonals of the body.
    return lengths_agree(points, kind, [kind](const NodePair &pair) {
      const unsigned int bits = pair[0] ^ pair[1];
      return is_simplex(kind) ? 0 : (bits & 1) + (bits >> 1 & 1) + (bits >> 2);
    });
  }


  bool
  is_rectangle(const Eigen::MatrixXd &points)
  {
    return lengths_agree(points,
                         CellKind::quadrilateral,
                         [](const NodePair &pair) {
                           return pair[0] ^ pair[1];
                         });
  }


  const char *
  regular_cells(const CellKind kind)
  {
    switch (kind)
      {
        case CellKind::triangle:
          return "equilateral triangles";
        case CellKind::quadrilateral:
          return "squares";
        case CellKind::tetrahedron:
          return "regular tetrahedra";
        default:
          return "cubes";
      }
  }
} // namespace springfit
