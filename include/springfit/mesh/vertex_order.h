#ifndef springfit_mesh_vertex_order_h
#define springfit_mesh_vertex_order_h

#include <springfit/core/cell_kind.h>

#include <vector>

namespace springfit
{
  /**
   * For each vertex of a cell in deal.II's numbering, which runs along the
   * axes, its position in that of gmsh, Abaqus, Medit and VTK, which runs
   * around a face.
   */
  const std::vector<unsigned int> &
  order_around_faces(CellKind kind);
} // namespace springfit

#endif
