#include <springfit/mesh/build_mesh.h>
#include <springfit/mesh/nodes.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <map>

namespace springfit
{
  namespace
  {
    template <int spacedim>
    std::vector<dealii::Point<spacedim>>
    points_of(const MeshDescription &description)
    {
      std::vector<dealii::Point<spacedim>> points(description.vertices.size());
      for (std::size_t v = 0; v < points.size(); ++v)
        for (int d = 0; d < spacedim; ++d)
          points[v][d] = description.vertices[v][d];
      return points;
    }

    template <int dim>
    std::vector<dealii::CellData<dim>>
    cells_of(const MeshDescription &description)
    {
      const unsigned int n = n_vertices(description.cell_kind);
      std::vector<dealii::CellData<dim>> cells;
      cells.reserve(description.n_cells());
      for (unsigned int c = 0; c < description.n_cells(); ++c)
        {
          dealii::CellData<dim> cell(n);
          std::copy_n(description.cell(c), n, cell.vertices.begin());
          cell.material_id = description.material_ids[c];
          cells.push_back(cell);
        }
      // deal.II wants neighbouring quadrilaterals and hexahedra to agree on
      // the direction of their common edges.
      if (!is_simplex(description.cell_kind))
        dealii::GridTools::consistently_order_cells(cells);
      return cells;
    }

    // By vertices rather than through SubCellData: deal.II refuses a
    // description of faces that are not on the boundary.
    template <int dim, int spacedim>
    void
    set_boundary_ids(dealii::Triangulation<dim, spacedim> &triangulation,
                     const MeshDescription &description)
    {
      std::map<std::vector<unsigned int>, unsigned int> id_of_face;
      for (const BoundaryFacet &facet : description.facets)
        {
          std::vector<unsigned int> vertices = facet.vertices;
          std::sort(vertices.begin(), vertices.end());
          id_of_face[vertices] = facet.id;
        }

      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary())
          {
            std::vector<unsigned int> vertices;
            for (const unsigned int v : face->vertex_indices())
              vertices.push_back(face->vertex_index(v));
            std::sort(vertices.begin(), vertices.end());
            const auto known = id_of_face.find(vertices);
            face->set_boundary_id(known == id_of_face.end() ? 0
                                                            : known->second);
          }
    }
  } // namespace


  template <int dim, int spacedim>
  std::unique_ptr<Mesh<dim, spacedim>>
  build_mesh(const MeshDescription &description, const unsigned int n_ranks)
  {
    auto mesh           = std::make_unique<Mesh<dim, spacedim>>();
    mesh->cell_kind     = description.cell_kind;
    mesh->warnings      = description.warnings;
    mesh->left_out      = description.left_out;
    mesh->straight_part = description.straight_part;
    mesh->boundary_names.insert(description.boundary_names.begin(),
                                description.boundary_names.end());
    mesh->material_names.insert(description.material_names.begin(),
                                description.material_names.end());
    mesh->unused_boundary_names = description.unused_boundary_names;
    mesh->unused_material_names = description.unused_material_names;

    mesh->triangulation.create_triangulation(points_of<spacedim>(description),
                                             cells_of<dim>(description),
                                             dealii::SubCellData());
    set_boundary_ids(mesh->triangulation, description);
    mesh->nodes = vertices_as_nodes(mesh->triangulation);
    if (n_ranks > 1)
      dealii::GridTools::partition_triangulation(
        n_ranks,
        mesh->triangulation,
        dealii::SparsityTools::Partitioner::metis);
    return mesh;
  }


  template std::unique_ptr<Mesh<2>>
  build_mesh<2>(const MeshDescription &, unsigned int);
  template std::unique_ptr<Mesh<2, 3>>
  build_mesh<2, 3>(const MeshDescription &, unsigned int);
  template std::unique_ptr<Mesh<3>>
  build_mesh<3>(const MeshDescription &, unsigned int);
} // namespace springfit
