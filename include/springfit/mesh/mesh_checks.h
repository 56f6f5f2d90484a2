#ifndef springfit_mesh_mesh_checks_h
#define springfit_mesh_mesh_checks_h

#include <springfit/mesh/mesh_description.h>

#include <string>
#include <vector>

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

  /**
   * Renumber the cells of each group of cells that are all negative (clockwise
   * in the plane, left-handed in space), with a warning.
   *
   * @throws InputError at a cell without measure, at a folded one (positive at
   * one corner, negative at another) and when only some cells of a group are
   * negative: these are inverted.
   */
  void
  check_orientation(MeshDescription &mesh);

  /**
   * Number of cells in each part, parts having no vertex in common, in the
   * order of their first vertices.
   */
  std::vector<unsigned int>
  connected_parts(const MeshDescription &mesh);

  /**
   * Add a warning each: when there are several parts, with the places where
   * they touch; when one part has doubled vertices (a crack); when vertices
   * hang in sides of other cells (conformity.h). Places in m.
   *
   * @throws InputError when more than two cells share a side.
   */
  void
  check_connection(MeshDescription &mesh);

  /**
   * Jacobians at the corners of a cell, each divided by the lengths of the
   * edges that meet there: 1 at a right angle, 0 where the cell is flat,
   * negative where it is inverted. One value for a simplex, 4 for a
   * quadrilateral, 16 for a hexahedron: also at the 2 x 2 x 2 Gauss points,
   * where the Jacobian can be negative although all corners are good.
   */
  std::vector<double>
  scaled_jacobians(const MeshDescription &mesh, unsigned int cell);

  /** Whether they all are positive, beyond rounding error. */
  bool
  has_positive_jacobians(const MeshDescription &mesh, unsigned int cell);

  /** "hexahedron 17 (around x = 0.01, y = 0, z = 0.2)", for messages. */
  std::string
  describe_cell(const MeshDescription &mesh, unsigned int cell);
} // namespace springfit

#endif
