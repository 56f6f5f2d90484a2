#ifndef springfit_mesh_cell_orientation_h
#define springfit_mesh_cell_orientation_h

#include <springfit/mesh/mesh_description.h>

#include <vector>

namespace springfit
{
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
} // namespace springfit

#endif
