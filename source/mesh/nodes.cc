#include <springfit/mesh/nodes.h>

namespace springfit
{
  template <int dim, int spacedim>
  Nodes<spacedim>
  vertices_as_nodes(const dealii::Triangulation<dim, spacedim> &triangulation)
  {
    Nodes<spacedim> nodes;
    nodes.places = triangulation.get_vertices();
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        nodes.of_cells.emplace_back();
        for (const unsigned int v : cell->vertex_indices())
          nodes.of_cells.back().push_back(cell->vertex_index(v));
      }
    if (triangulation.n_active_cells() == 0)
      return nodes;
    const auto cell      = triangulation.begin_active();
    const auto reference = cell->reference_cell();
    for (const unsigned int f : cell->face_indices())
      {
        nodes.of_faces.emplace_back();
        for (const unsigned int v : cell->face(f)->vertex_indices())
          nodes.of_faces.back().push_back(
            reference.face_to_cell_vertices(f, v, 1));
      }
    return nodes;
  }

  template Nodes<2>
  vertices_as_nodes(const dealii::Triangulation<2> &);
  template Nodes<3>
  vertices_as_nodes(const dealii::Triangulation<2, 3> &);
  template Nodes<3>
  vertices_as_nodes(const dealii::Triangulation<3> &);
} // namespace springfit
