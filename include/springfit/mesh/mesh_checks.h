#ifndef springfit_mesh_mesh_checks_h
#define springfit_mesh_mesh_checks_h

#include <springfit/mesh/mesh_description.h>

namespace springfit
{
  /**
   * Everything below, in an order in which each check may rely on those
   * before it. Afterwards every cell has a positive measure, and a positive
   * Jacobian at each of its corners.
   *
   * @throws InputError that names the first offending cell or vertex.
   */
  void
  check_mesh(MeshDescription &mesh);

  /**
   * The same of a surface in space: afterwards every cell has an area. Which
   * side of it is up has no meaning.
   *
   * @throws InputError that names the first offending cell or vertex.
   */
  void
  check_surface(MeshDescription &mesh);

  /** @throws InputError when there are no cells. */
  void
  check_not_empty(const MeshDescription &mesh);

  /** @throws InputError at a coordinate that is not a finite number. */
  void
  check_coordinates(const MeshDescription &mesh);

  /** @throws InputError when a vertex belongs to no cell. */
  void
  check_vertices_are_used(const MeshDescription &mesh);

  /** @throws InputError when two cells have the same vertices. */
  void
  check_no_duplicate_cells(const MeshDescription &mesh);
} // namespace springfit

#endif
