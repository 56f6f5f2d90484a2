#ifndef springfit_mesh_nodes_h
#define springfit_mesh_nodes_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace springfit
{
  /**
   * The places that bear displacements, numbered: first all vertices of a
   * triangulation in its order, then, of elements of degree 2, the midpoints of
   * edges, of quadrilateral faces and of quadrilaterals or hexahedra
   * themselves.
   */
  template <int spacedim>
  struct Nodes
  {
    unsigned int degree = 1;

    std::vector<dealii::Point<spacedim>> places; // at rest, m

    /** Numbers of the nodes of a cell, by its active_cell_index(). */
    std::vector<std::vector<unsigned int>> of_cells;

    /** Positions in of_cells of the nodes of each face of a cell. */
    std::vector<std::vector<unsigned int>> of_faces;

    unsigned int
    size() const
    {
      return places.size();
    }

    template <typename Cell>
    const std::vector<unsigned int> &
    of(const Cell &cell) const
    {
      return of_cells[cell->active_cell_index()];
    }
  };

  /** Those of linear elements. */
  template <int dim, int spacedim>
  Nodes<spacedim>
  vertices_as_nodes(const dealii::Triangulation<dim, spacedim> &triangulation);
} // namespace springfit

#endif
