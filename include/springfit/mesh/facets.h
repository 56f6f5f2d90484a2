#ifndef springfit_mesh_facets_h
#define springfit_mesh_facets_h

#include <springfit/mesh/mesh_description.h>

#include <functional>
#include <vector>

namespace springfit
{
  /**
   * The sides of a cell as positions in the cell's list of vertices: edges of
   * plane cells, faces of the others. The vertices of a quadrilateral face
   * come in lexicographic order.
   */
  const std::vector<std::vector<unsigned int>> &
  sides_of(CellKind kind);

  /** A side by its cell and its place in sides_of(). */
  struct CellSide
  {
    unsigned int cell;
    unsigned int side;
  };

  /**
   * The sides that belong to one cell only, in the order of the cells.
   *
   * @throws InputError when more than two cells share a side.
   */
  std::vector<CellSide>
  boundary_cell_sides(const MeshDescription &mesh);

  /**
   * The sides that belong to one cell only, in the order of the cells, each
   * with its vertices in ascending order.
   *
   * @throws InputError when more than two cells share a side.
   */
  std::vector<std::vector<unsigned int>>
  boundary_sides(const MeshDescription &mesh);

  /**
   * Replace the facets of @p mesh by all its boundary sides, with the id that
   * @p id_of gives to the points of a side.
   */
  void
  label_boundary(
    MeshDescription &mesh,
    const std::function<unsigned int(const std::vector<MeshPoint> &)> &id_of);
} // namespace springfit

#endif
