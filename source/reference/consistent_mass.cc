#include <springfit/core/cell_kind.h>
#include <springfit/reference/consistent_mass.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <vector>

namespace springfit
{
  template <int dim, int spacedim>
  Eigen::SparseMatrix<double>
  consistent_mass(const Mesh<dim, spacedim> &mesh,
                  const Element<dim, spacedim> &element,
                  const MaterialTable &materials)
  {
    const unsigned int n_points = mesh.nodes.degree + 1;
    const dealii::Quadrature<dim> quadrature =
      is_simplex(mesh.cell_kind)
        ? dealii::Quadrature<dim>(dealii::QGaussSimplex<dim>(n_points))
        : dealii::Quadrature<dim>(dealii::QGauss<dim>(n_points));
    dealii::FEValues<dim, spacedim> values(*element.mapping,
                                           *element.scalar,
                                           quadrature,
                                           dealii::update_values |
                                             dealii::update_JxW_values);
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        values.reinit(cell);
        const CellMaterial &material = materials.at(cell->material_id());
        const auto &nodes            = mesh.nodes.of(cell);
        const double factor = material.constants.density * material.thickness;
        for (const unsigned int a : values.dof_indices())
          for (const unsigned int b : values.dof_indices())
            {
              double entry = 0.;
              for (const unsigned int q : values.quadrature_point_indices())
                entry += values.shape_value(a, q) * values.shape_value(b, q) *
                         values.JxW(q);
              entries.emplace_back(nodes[a], nodes[b], factor * entry);
            }
      }
    const unsigned int n = mesh.nodes.size();
    Eigen::SparseMatrix<double> mass(n, n);
    mass.setFromTriplets(entries.begin(), entries.end());
    return mass;
  }

  template Eigen::SparseMatrix<double>
  consistent_mass(const Mesh<2> &, const Element<2> &, const MaterialTable &);
  template Eigen::SparseMatrix<double>
  consistent_mass(const Mesh<2, 3> &,
                  const Element<2, 3> &,
                  const MaterialTable &);
  template Eigen::SparseMatrix<double>
  consistent_mass(const Mesh<3> &, const Element<3> &, const MaterialTable &);
} // namespace springfit
