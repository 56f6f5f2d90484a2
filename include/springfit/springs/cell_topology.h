#ifndef springfit_springs_cell_topology_h
#define springfit_springs_cell_topology_h

#include <springfit/core/cell_kind.h>

#include <array>
#include <optional>
#include <vector>

namespace springfit
{
  /** Two vertices of a cell, the smaller one first. */
  using NodePair = std::array<unsigned int, 2>;

  /**
   * Every pair of vertices of a cell, in lexicographic order: a fully
   * connected cell of 3, 6, 6 or 28 springs.
   */
  const std::vector<NodePair> &
  node_pairs(CellKind kind);

  /**
   * The axis of the reference cell along which an edge of a quadrilateral or
   * hexahedron runs; nothing for a diagonal.
   */
  std::optional<int>
  edge_axis(const NodePair &pair);

  /**
   * The renumberings of the reference cell's vertices under which its P1 or Q1
   * element remains the same, mirror images included: 6, 8, 24, 48 of them.
   * Vertex v goes to vertex p[v]. The vertices of quadrilaterals and
   * hexahedra are numbered lexicographically, x fastest.
   */
  const std::vector<std::vector<unsigned int>> &
  symmetries(CellKind kind);
} // namespace springfit

#endif
