#ifndef springfit_mesh_flat_sides_h
#define springfit_mesh_flat_sides_h

#include <springfit/mesh/mesh_description.h>

#include <map>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * gmsh's vertices lie on flat sides up to rounding error only: move those
   * within 1e-9 @p size of the plane exactly onto it. @p direction 0, 1 or 2
   * is the plane's normal x, y or z; @p position and @p size in m.
   */
  void
  snap_to_plane(MeshDescription &mesh,
                unsigned int direction,
                double position,
                double size);

  /** Whether all points lie exactly in that plane. */
  bool
  lie_in_plane(const std::vector<MeshPoint> &points,
               unsigned int direction,
               double position);

  /**
   * The boundary ids of an object with an end in each direction, and their
   * names: 0 "x min", 1 "x max", 2 "y min", ...; 2 @p dim of them.
   */
  std::multimap<unsigned int, std::string>
  names_of_sides(int dim);
} // namespace springfit

#endif
