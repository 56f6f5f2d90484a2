#include <springfit/calibration/cell_network.h>

namespace springfit
{
  template <int dim>
  SpringNetwork
  assemble_network(const Mesh<dim> &mesh,
                   const DistinctCells &cells,
                   const std::vector<CellModel> &models,
                   const Element<dim> &element,
                   const MaterialTable &materials)
  {
    const auto iterators = cells_by_index(mesh);
    const auto &vertices = mesh.triangulation.get_vertices();
    Eigen::MatrixXd nodes(dim, vertices.size());
    for (unsigned int v = 0; v < vertices.size(); ++v)
      for (int d = 0; d < dim; ++d)
        nodes(d, v) = vertices[v][d];

    NetworkBuilder builder(nodes);
    CellMatrices<dim> cell_matrices(element);
    std::vector<unsigned int> cell_nodes;
    for (unsigned int c = 0; c < iterators.size(); ++c)
      {
        const auto &copy = cells.copies[c];
        for (const auto &family : models[copy.distinct].families)
          builder.add(family, copy.nodes, copy.scale);

        cell_nodes.clear();
        for (const unsigned int v : iterators[c]->vertex_indices())
          cell_nodes.push_back(iterators[c]->vertex_index(v));
        builder.add_masses(
          cell_nodes,
          cell_matrices.masses(iterators[c],
                               materials.at(iterators[c]->material_id())));
      }
    return builder.build();
  }

  template SpringNetwork
  assemble_network<2>(const Mesh<2> &,
                      const DistinctCells &,
                      const std::vector<CellModel> &,
                      const Element<2> &,
                      const MaterialTable &);
  template SpringNetwork
  assemble_network<3>(const Mesh<3> &,
                      const DistinctCells &,
                      const std::vector<CellModel> &,
                      const Element<3> &,
                      const MaterialTable &);
} // namespace springfit
