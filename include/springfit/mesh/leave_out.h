#ifndef springfit_mesh_leave_out_h
#define springfit_mesh_leave_out_h

#include <springfit/mesh/mesh_description.h>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * Remove the cells of some materials, with the vertices and facets that
   * nothing else has. Where what remains touched them it has a boundary of its
   * own, named as the material ("left out 3", if that has no name), unless the
   * sides there have an id already. The names of the materials become unused
   * ones, and mesh.left_out says what was done.
   *
   * @param materials ids or names
   * @throws EntryError of Geometry/Leave out when there is no such material,
   * or when nothing else is left
   */
  void
  leave_out(MeshDescription &mesh, const std::vector<std::string> &materials);
} // namespace springfit

#endif
