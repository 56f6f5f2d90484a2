#include <springfit/reference/cell_frame.h>
#include <springfit/reference/cell_matrices.h>

#include <vector>

namespace springfit
{
  namespace
  {
    /** The gradients of all shape functions in the coordinates of a cell. */
    template <int dim, int spacedim>
    std::vector<dealii::Tensor<1, dim>>
    flat_gradients(const dealii::FEValues<dim, spacedim> &values,
                   const Eigen::Matrix<double, spacedim, dim> &frame,
                   const unsigned int q)
    {
      std::vector<dealii::Tensor<1, dim>> gradients;
      for (const unsigned int a : values.dof_indices())
        if constexpr (dim == spacedim)
          gradients.push_back(values.shape_grad(a, q));
        else
          {
            dealii::Tensor<1, dim> gradient;
            for (int d = 0; d < dim; ++d)
              for (int i = 0; i < spacedim; ++i)
                gradient[d] += frame(i, d) * values.shape_grad(a, q)[i];
            gradients.push_back(gradient);
          }
      return gradients;
    }
  } // namespace

  template <int dim, int spacedim>
  CellMatrices<dim, spacedim>::CellMatrices(
    const Element<dim, spacedim> &element)
    : values_(*element.mapping,
              *element.scalar,
              element.quadrature,
              dealii::update_gradients | dealii::update_JxW_values)
    , nodal_values_(*element.mapping,
                    *element.scalar,
                    element.nodal_quadrature,
                    dealii::update_JxW_values)
  {}

  template <int dim, int spacedim>
  Eigen::MatrixXd
  CellMatrices<dim, spacedim>::stiffness(const Cell &cell,
                                         const CellMaterial &material)
  {
    values_.reinit(cell);
    const auto frame     = cell_frame<dim, spacedim>(cell);
    const unsigned int n = values_.dofs_per_cell;
    const double lambda  = material.lame.lambda;
    const double mu      = material.lame.mu;

    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(dim * n, dim * n);
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        const auto gradients = flat_gradients(values_, frame, q);
        const double weight  = values_.JxW(q) * material.thickness;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            {
              const auto &grad_a   = gradients[a];
              const auto &grad_b   = gradients[b];
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

  template <int dim, int spacedim>
  Eigen::VectorXd
  CellMatrices<dim, spacedim>::masses(const Cell &cell,
                                      const CellMaterial &material)
  {
    nodal_values_.reinit(cell);
    Eigen::VectorXd masses(nodal_values_.n_quadrature_points);
    for (const unsigned int v : nodal_values_.quadrature_point_indices())
      masses[v] = nodal_values_.JxW(v);
    return masses * (volume(cell) * material.thickness *
                     material.constants.density / masses.sum());
  }

  template <int dim, int spacedim>
  Eigen::MatrixXd
  CellMatrices<dim, spacedim>::integrated_gradients(const Cell &cell)
  {
    values_.reinit(cell);
    const auto frame = cell_frame<dim, spacedim>(cell);
    Eigen::MatrixXd integrals =
      Eigen::MatrixXd::Zero(dim, values_.dofs_per_cell);
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        const auto gradients = flat_gradients(values_, frame, q);
        for (const unsigned int v : values_.dof_indices())
          for (int d = 0; d < dim; ++d)
            integrals(d, v) += values_.JxW(q) * gradients[v][d];
      }
    return integrals;
  }

  template <int dim, int spacedim>
  double
  CellMatrices<dim, spacedim>::volume(const Cell &cell)
  {
    values_.reinit(cell);
    double volume = 0.;
    for (const unsigned int q : values_.quadrature_point_indices())
      volume += values_.JxW(q);
    return volume;
  }

  template <int dim, int spacedim>
  Eigen::MatrixXd
  in_space(const Eigen::Matrix<double, spacedim, dim> &frame,
           const Eigen::MatrixXd &flat)
  {
    if constexpr (dim == spacedim)
      return flat;
    else
      {
        const Eigen::Index n = flat.rows() / dim;
        Eigen::MatrixXd matrix(spacedim * n, spacedim * n);
        for (Eigen::Index a = 0; a < n; ++a)
          for (Eigen::Index b = 0; b < n; ++b)
            matrix.block<spacedim, spacedim>(spacedim * a, spacedim * b) =
              frame * flat.block<dim, dim>(dim * a, dim * b) *
              frame.transpose();
        return matrix;
      }
  }

  template class CellMatrices<2>;
  template class CellMatrices<2, 3>;
  template class CellMatrices<3>;
  template Eigen::MatrixXd
  in_space<2, 2>(const Eigen::Matrix2d &, const Eigen::MatrixXd &);
  template Eigen::MatrixXd
  in_space<2, 3>(const Eigen::Matrix<double, 3, 2> &, const Eigen::MatrixXd &);
  template Eigen::MatrixXd
  in_space<3, 3>(const Eigen::Matrix3d &, const Eigen::MatrixXd &);
} // namespace springfit
