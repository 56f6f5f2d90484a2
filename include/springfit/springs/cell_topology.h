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

  /** The ends and the middle of an angle: {end, middle, end}. */
  using NodeTriple = std::array<unsigned int, 3>;

  /**
   * The angles of a cell's faces, between two edges that meet at a vertex: 3,
   * 4, 12 or 24 of them. They are sorted by the middle vertex, then by the
   * ends, of which the smaller one is the first: the first angle of a
   * quadrilateral is {1, 0, 2}, those of a tetrahedron begin with {1, 0, 2},
   * {1, 0, 3}, {2, 0, 3}, {0, 1, 2}.
   */
  const std::vector<NodeTriple> &
  cell_angles(CellKind kind);

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
