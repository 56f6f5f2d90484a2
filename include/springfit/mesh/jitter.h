#ifndef springfit_mesh_jitter_h
#define springfit_mesh_jitter_h

#include <springfit/mesh/mesh_description.h>

#include <vector>

namespace springfit
{
  /**
   * Where the vertices of @p mesh go, in m: each coordinate (two in the plane)
   * of a vertex inside the object moves by a number uniform in [-fraction,
   * fraction] times the shortest edge of @p mesh that meets there, so that the
   * vertex moves by at most sqrt(dim) times that. Vertices on the boundary
   * keep their places, and so do the sides of the object and their areas.
   *
   * The numbers are the same in every run and on every machine: the raw
   * output of std::mt19937 with its default seed, mapped to [-1, 1], for the
   * coordinates of one vertex inside after the other.
   *
   * @throws InputError when more than two cells share a side.
   */
  std::vector<MeshPoint>
  jittered_vertices(const MeshDescription &mesh, double fraction);

  /**
   * Move the vertices of a mesh that check_mesh() has accepted as
   * jittered_vertices() says; a warning when none of them is inside.
   *
   * @throws EntryError that names Geometry/Jitter when a cell is no longer
   * positive at one of its places (has_positive_jacobians()); it tells how far
   * one has to go down.
   */
  void
  jitter(MeshDescription &mesh, double fraction);
} // namespace springfit

#endif
