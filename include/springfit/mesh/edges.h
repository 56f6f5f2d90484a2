#ifndef springfit_mesh_edges_h
#define springfit_mesh_edges_h

#include <springfit/mesh/mesh_description.h>

#include <utility>
#include <vector>

namespace springfit
{
  /** The edges of a cell as positions in the cell's list of vertices. */
  std::vector<std::pair<unsigned int, unsigned int>>
  edges_of(CellKind kind);

  /**
   * For each vertex the length in m of the shortest of the cells' edges that
   * meet there; the largest number for a vertex without a cell.
   */
  std::vector<double>
  shortest_edges(const MeshDescription &mesh);
} // namespace springfit

#endif
