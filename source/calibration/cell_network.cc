#include <springfit/calibration/cell_network.h>
#include <springfit/springs/volume.h>

#include <cmath>

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
        const auto &copy       = cells.copies[c];
        const CellModel &model = models[copy.distinct];
        const auto &pairs      = node_pairs(mesh.cell_kind);
        // Stiffness is as the length to the power dim - 2. The tangent of a
        // volume spring is its constant times the gradient's square, which
        // is as the power 2 (dim - 1).
        const double factor = std::pow(copy.scale, dim - 2);
        builder.add_springs(copy.nodes, pairs, factor * model.k);

        std::vector<LengthCoupling> couplings = model.couplings;
        for (auto &coupling : couplings)
          coupling.stiffness *= factor;
        builder.add_couplings(copy.nodes, pairs, couplings);

        // The tangent of an angle is its constant times a square of the
        // angle's gradient, which is as the length to the power -1.
        if (model.angle_stiffness.size() > 0)
          builder.add_angles(copy.nodes,
                             cell_angles(mesh.cell_kind),
                             std::pow(copy.scale, dim) * model.angle_stiffness);

        cell_nodes.clear();
        for (const unsigned int v : iterators[c]->vertex_indices())
          cell_nodes.push_back(iterators[c]->vertex_index(v));
        // With the cell's own numbering, in which the volume is positive;
        // a mirrored copy in that of the representative has a negative one.
        if (model.volume_stiffness)
          builder.add_volume(cell_nodes,
                             std::pow(copy.scale, -dim) *
                               *model.volume_stiffness,
                             volume(cell_points<dim>(iterators[c]),
                                    mesh.cell_kind));
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
