#ifndef springfit_mesh_crossed_diagonals_h
#define springfit_mesh_crossed_diagonals_h

#include <springfit/mesh/mesh_description.h>

#include <array>
#include <vector>

namespace springfit
{
  /**
   * Where tetrahedra on both sides of a quadrilateral split it by different
   * diagonals: four vertices, in ascending order, whose four triangles all are
   * on the boundary of @p mesh although they make no cell. They enclose a gap
   * or an overlap, flat if the quadrilateral is. Empty for other cells.
   *
   * @throws InputError when more than two cells share a side.
   */
  std::vector<std::array<unsigned int, 4>>
  crossed_diagonals(const MeshDescription &mesh);
} // namespace springfit

#endif
