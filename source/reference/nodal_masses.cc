#include <springfit/reference/cell_matrices.h>
#include <springfit/reference/nodal_masses.h>

#include <cstddef>

namespace springfit
{
  template <int dim, int spacedim>
  Eigen::VectorXd
  nodal_masses(const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               const MaterialTable &materials)
  {
    CellMatrices<dim, spacedim> matrices(element);
    Eigen::VectorXd masses = Eigen::VectorXd::Zero(mesh.nodes.size());
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const Eigen::VectorXd of_cell =
          matrices.masses(cell, materials.at(cell->material_id()));
        const auto &nodes = mesh.nodes.of(cell);
        for (std::size_t a = 0; a < nodes.size(); ++a)
          masses[nodes[a]] += of_cell[a];
      }
    return masses;
  }

  template Eigen::VectorXd
  nodal_masses(const Mesh<2> &, const Element<2> &, const MaterialTable &);
  template Eigen::VectorXd
  nodal_masses(const Mesh<2, 3> &,
               const Element<2, 3> &,
               const MaterialTable &);
  template Eigen::VectorXd
  nodal_masses(const Mesh<3> &, const Element<3> &, const MaterialTable &);
} // namespace springfit
