#include <springfit/reference/cell_matrices.h>

namespace springfit
{
  template <int dim>
  Eigen::MatrixXd
  cell_points(
    const typename dealii::Triangulation<dim>::active_cell_iterator &cell)
  {
    Eigen::MatrixXd points(dim, cell->n_vertices());
    for (const unsigned int v : cell->vertex_indices())
      for (int d = 0; d < dim; ++d)
        points(d, v) = cell->vertex(v)[d];
    return points;
  }

  template <int dim>
  CellMatrices<dim>::CellMatrices(const Element<dim> &element)
    : values_(*element.mapping,
              *element.scalar,
              element.quadrature,
              dealii::update_gradients | dealii::update_JxW_values)
    , nodal_values_(*element.mapping,
                    *element.scalar,
                    element.nodal_quadrature,
                    dealii::update_JxW_values)
  {}

  template <int dim>
  Eigen::MatrixXd
  CellMatrices<dim>::stiffness(const Cell &cell, const CellMaterial &material)
  {
    values_.reinit(cell);
    const unsigned int n = values_.dofs_per_cell;
    const double lambda  = material.lame.lambda;
    const double mu      = material.lame.mu;

    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(dim * n, dim * n);
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        const double weight = values_.JxW(q) * material.thickness;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            {
              const auto &grad_a   = values_.shape_grad(a, q);
              const auto &grad_b   = values_.shape_grad(b, q);
              const double product = grad_a * grad_b;
              for (int i = 0; i < dim; ++i)
                for (int j = 0; j < dim; ++j)
                  R(dim * a + i, dim * b + j) +=
                    weight *
                    (lambda * grad_a[i] * grad_b[j] +
                     mu * grad_a[j] * grad_b[i] + (i == j ? mu * product : 0.));
            }
      }
    return R;
  }

  template <int dim>
  Eigen::VectorXd
  CellMatrices<dim>::masses(const Cell &cell, const CellMaterial &material)
  {
    nodal_values_.reinit(cell);
    Eigen::VectorXd masses(nodal_values_.n_quadrature_points);
    for (const unsigned int v : nodal_values_.quadrature_point_indices())
      masses[v] = nodal_values_.JxW(v);
    return masses * (volume(cell) * material.thickness *
                     material.constants.density / masses.sum());
  }

  template <int dim>
  Eigen::MatrixXd
  CellMatrices<dim>::integrated_gradients(const Cell &cell)
  {
    values_.reinit(cell);
    Eigen::MatrixXd integrals =
      Eigen::MatrixXd::Zero(dim, values_.dofs_per_cell);
    for (const unsigned int q : values_.quadrature_point_indices())
      for (const unsigned int v : values_.dof_indices())
        for (int d = 0; d < dim; ++d)
          integrals(d, v) += values_.JxW(q) * values_.shape_grad(v, q)[d];
    return integrals;
  }

  template <int dim>
  double
  CellMatrices<dim>::volume(const Cell &cell)
  {
    values_.reinit(cell);
    double volume = 0.;
    for (const unsigned int q : values_.quadrature_point_indices())
      volume += values_.JxW(q);
    return volume;
  }

  template class CellMatrices<2>;
  template class CellMatrices<3>;

  template Eigen::MatrixXd
  cell_points<2>(const dealii::Triangulation<2>::active_cell_iterator &);
  template Eigen::MatrixXd
  cell_points<3>(const dealii::Triangulation<3>::active_cell_iterator &);
} // namespace springfit
