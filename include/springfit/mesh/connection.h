#ifndef springfit_mesh_connection_h
#define springfit_mesh_connection_h

#include <springfit/mesh/mesh_description.h>

#include <vector>

namespace springfit
{
  /**
   * Number of cells in each part, parts having no vertex in common, in the
   * order of their first vertices.
   */
  std::vector<unsigned int>
  connected_parts(const MeshDescription &mesh);

  /**
   * Add a warning each: when there are several parts, with the places where
   * they touch; when one part has doubled vertices (a crack); when vertices
   * hang in sides of other cells (conformity.h); when tetrahedra split a
   * quadrilateral by different diagonals (crossed_diagonals.h). Places in m.
   *
   * @throws InputError when more than two cells share a side.
   */
  void
  check_connection(MeshDescription &mesh);
} // namespace springfit

#endif
