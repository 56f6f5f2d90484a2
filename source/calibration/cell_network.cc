#include <springfit/calibration/cell_network.h>
#include <springfit/springs/kinds_in_space.h>

#include <numeric>

namespace springfit
{
  namespace
  {
    /** Springs of a cell as those of a mesh. */
    template <int dim, int spacedim>
    Family
    placed(Family family)
    {
      if constexpr (dim == spacedim)
        return family;
      else
        return in_space(family);
    }
  } // namespace

  template <int dim, int spacedim>
  SpringNetwork
  assemble_network(const Mesh<dim, spacedim> &mesh,
                   const DistinctCells &cells,
                   const ModelOfCell &model_of_cell,
                   const Element<dim, spacedim> &element,
                   const MaterialTable &materials)
  {
    const auto iterators = cells_by_index(mesh);
    const auto &vertices = mesh.triangulation.get_vertices();
    Eigen::MatrixXd nodes(spacedim, vertices.size());
    for (unsigned int v = 0; v < vertices.size(); ++v)
      for (int d = 0; d < spacedim; ++d)
        nodes(d, v) = vertices[v][d];

    NetworkBuilder builder(nodes);
    CellMatrices<dim, spacedim> cell_matrices(element);
    std::vector<unsigned int> cell_nodes;
    for (unsigned int c = 0; c < iterators.size(); ++c)
      {
        const auto &copy = cells.copies[c];
        if (const CellModel *model = model_of_cell(c))
          for (const auto &family : model->families)
            builder.add(placed<dim, spacedim>(scaled(family, copy.scale)),
                        copy.nodes);

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

  template <int dim, int spacedim>
  SpringNetwork
  assemble_network(const Mesh<dim, spacedim> &mesh,
                   const DistinctCells &cells,
                   const std::vector<CellModel> &models,
                   const Element<dim, spacedim> &element,
                   const MaterialTable &materials)
  {
    return assemble_network(
      mesh,
      cells,
      [&](const unsigned int c) { return &models[cells.copies[c].distinct]; },
      element,
      materials);
  }

  template <int dim, int spacedim>
  Families
  families_of_cell(const CellModel &model,
                   const CellCopy &copy,
                   const Eigen::MatrixXd &nodes)
  {
    std::vector<unsigned int> numbers(copy.nodes.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    NetworkBuilder builder(nodes);
    for (const auto &family : model.families)
      builder.add(placed<dim, spacedim>(scaled(family, copy.scale)), numbers);
    return builder.build().families;
  }

  template SpringNetwork
  assemble_network<2>(const Mesh<2> &,
                      const DistinctCells &,
                      const std::vector<CellModel> &,
                      const Element<2> &,
                      const MaterialTable &);
  template SpringNetwork
  assemble_network<2, 3>(const Mesh<2, 3> &,
                         const DistinctCells &,
                         const std::vector<CellModel> &,
                         const Element<2, 3> &,
                         const MaterialTable &);
  template SpringNetwork
  assemble_network<3>(const Mesh<3> &,
                      const DistinctCells &,
                      const std::vector<CellModel> &,
                      const Element<3> &,
                      const MaterialTable &);
  template SpringNetwork
  assemble_network<2>(const Mesh<2> &,
                      const DistinctCells &,
                      const ModelOfCell &,
                      const Element<2> &,
                      const MaterialTable &);
  template SpringNetwork
  assemble_network<2, 3>(const Mesh<2, 3> &,
                         const DistinctCells &,
                         const ModelOfCell &,
                         const Element<2, 3> &,
                         const MaterialTable &);
  template SpringNetwork
  assemble_network<3>(const Mesh<3> &,
                      const DistinctCells &,
                      const ModelOfCell &,
                      const Element<3> &,
                      const MaterialTable &);
  template Families
  families_of_cell<2, 2>(const CellModel &,
                         const CellCopy &,
                         const Eigen::MatrixXd &);
  template Families
  families_of_cell<2, 3>(const CellModel &,
                         const CellCopy &,
                         const Eigen::MatrixXd &);
  template Families
  families_of_cell<3, 3>(const CellModel &,
                         const CellCopy &,
                         const Eigen::MatrixXd &);
} // namespace springfit
