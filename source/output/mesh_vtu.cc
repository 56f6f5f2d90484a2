#include <springfit/output/mesh_vtu.h>

#include <cstddef>

namespace springfit
{
  namespace
  {
    template <int dim, int spacedim>
    UnstructuredGrid
    grid_of_nodes(const Mesh<dim, spacedim> &mesh,
                  const std::vector<NodalField> &fields)
    {
      const auto &vertices = mesh.triangulation.get_vertices();
      Eigen::MatrixXd places(spacedim, vertices.size());
      for (std::size_t v = 0; v < vertices.size(); ++v)
        for (int d = 0; d < spacedim; ++d)
          places(d, v) = vertices[v][d];
      return node_grid(places, fields);
    }

    /** Of a cell or a face, in deal.II's order. */
    template <typename Iterator>
    std::vector<unsigned int>
    nodes_of(const Iterator &object)
    {
      std::vector<unsigned int> nodes;
      for (const unsigned int v : object->vertex_indices())
        nodes.push_back(object->vertex_index(v));
      return nodes;
    }

    /** A number per cell. */
    VtuArray
    array_of(const std::string &name, const std::vector<int> &numbers)
    {
      return {name,
              Eigen::MatrixXi(Eigen::Map<const Eigen::RowVectorXi>(
                numbers.data(), numbers.size()))};
    }

    template <int dim, int spacedim, typename Condition>
    UnstructuredGrid
    grid_of_cells(const Mesh<dim, spacedim> &mesh,
                  const Condition &is_wanted,
                  const std::vector<NodalField> &fields)
    {
      auto grid = grid_of_nodes(mesh, fields);
      std::vector<int> materials;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        if (is_wanted(cell->active_cell_index()))
          {
            add_cell(grid, mesh.cell_kind, nodes_of(cell));
            materials.push_back(cell->material_id());
          }
      grid.cell_data.push_back(array_of("material", materials));
      return grid;
    }

    template <typename Face>
    void
    add_face(UnstructuredGrid &grid, const Face &face)
    {
      const auto nodes = nodes_of(face);
      if (nodes.size() == 2)
        add_cell(grid, VtkCell::line, nodes);
      else
        add_cell(grid,
                 nodes.size() == 3 ? CellKind::triangle
                                   : CellKind::quadrilateral,
                 nodes);
    }
  } // namespace

  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<NodalField> &fields)
  {
    write_mesh_vtu(path, mesh, fields, std::vector<CellField>());
  }

  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<NodalField> &fields,
                 const std::vector<CellField> &cell_fields)
  {
    auto grid = grid_of_cells(
      mesh, [](unsigned int) { return true; }, fields);
    for (const auto &field : cell_fields)
      grid.cell_data.push_back(
        {field.name, Eigen::MatrixXd(field.values.transpose())});
    write_vtu(path, grid);
  }

  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<bool> &cells,
                 const std::vector<NodalField> &fields)
  {
    write_vtu(path,
              without_loose_points(grid_of_cells(
                mesh, [&](const unsigned int c) { return cells[c]; }, fields)));
  }

  template <int dim, int spacedim>
  void
  write_boundaries_vtu(const std::filesystem::path &path,
                       const Mesh<dim, spacedim> &mesh)
  {
    auto grid = grid_of_nodes(mesh, {});
    std::vector<int> boundaries;
    for (const auto &face : mesh.triangulation.active_face_iterators())
      if (face->at_boundary())
        {
          add_face(grid, face);
          boundaries.push_back(face->boundary_id());
        }
    grid.cell_data.push_back(array_of("boundary", boundaries));
    write_vtu(path, without_loose_points(grid));
  }

  template void
  write_mesh_vtu<2>(const std::filesystem::path &,
                    const Mesh<2> &,
                    const std::vector<NodalField> &);
  template void
  write_mesh_vtu<2>(const std::filesystem::path &,
                    const Mesh<2> &,
                    const std::vector<NodalField> &,
                    const std::vector<CellField> &);
  template void
  write_mesh_vtu<2>(const std::filesystem::path &,
                    const Mesh<2> &,
                    const std::vector<bool> &,
                    const std::vector<NodalField> &);
  template void
  write_boundaries_vtu<2>(const std::filesystem::path &, const Mesh<2> &);
  template void
  write_mesh_vtu<2, 3>(const std::filesystem::path &,
                       const Mesh<2, 3> &,
                       const std::vector<NodalField> &);
  template void
  write_mesh_vtu<2, 3>(const std::filesystem::path &,
                       const Mesh<2, 3> &,
                       const std::vector<NodalField> &,
                       const std::vector<CellField> &);
  template void
  write_mesh_vtu<2, 3>(const std::filesystem::path &,
                       const Mesh<2, 3> &,
                       const std::vector<bool> &,
                       const std::vector<NodalField> &);
  template void
  write_boundaries_vtu<2, 3>(const std::filesystem::path &, const Mesh<2, 3> &);
  template void
  write_mesh_vtu<3>(const std::filesystem::path &,
                    const Mesh<3> &,
                    const std::vector<NodalField> &);
  template void
  write_mesh_vtu<3>(const std::filesystem::path &,
                    const Mesh<3> &,
                    const std::vector<NodalField> &,
                    const std::vector<CellField> &);
  template void
  write_mesh_vtu<3>(const std::filesystem::path &,
                    const Mesh<3> &,
                    const std::vector<bool> &,
                    const std::vector<NodalField> &);
  template void
  write_boundaries_vtu<3>(const std::filesystem::path &, const Mesh<3> &);
} // namespace springfit
