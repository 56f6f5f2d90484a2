#include <springfit/reference/cell_energy.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace springfit
{
  namespace
  {
    template <int dim>
    using Tensor = Eigen::Matrix<double, dim, dim>;

    template <int dim>
    std::optional<MaterialState<dim>>
    neo_hookean_of(const Tensor<dim> &F, const CellMaterial &material)
    {
      if constexpr (dim == 2)
        if (material.plane_state == PlaneState::stress)
          return neo_hookean_plane_stress(F, material.lame);
      return neo_hookean<dim>(F, material.lame);
    }

    template <int dim>
    std::optional<MaterialState<dim>>
    material_state(const MaterialLaw law,
                   const Tensor<dim> &F,
                   const CellMaterial &material)
    {
      return law == MaterialLaw::st_venant_kirchhoff
               ? st_venant_kirchhoff<dim>(F, material.lame)
               : neo_hookean_of<dim>(F, material);
    }

    /** B: the change of Green's strain in Voigt's order is B delta u. */
    template <int dim>
    Eigen::MatrixXd
    strain_gradients(const Tensor<dim> &F, const Eigen::MatrixXd &gradients)
    {
      constexpr int n_voigt = MaterialState<dim>::n_voigt;
      Eigen::MatrixXd B(n_voigt, dim * gradients.cols());
      for (Eigen::Index a = 0; a < gradients.cols(); ++a)
        for (int i = 0; i < dim; ++i)
          {
            for (int k = 0; k < dim; ++k)
              B(k, dim * a + i) = F(i, k) * gradients(k, a);
            for (int k = 0; k < n_voigt - dim; ++k)
              {
                const int l = (k + 1) % dim;
                B(dim + k, dim * a + i) =
                  F(i, k) * gradients(l, a) + F(i, l) * gradients(k, a);
              }
          }
      return B;
    }
  } // namespace

  template <int dim>
  CellEnergy<dim>::CellEnergy(const Element<dim> &element,
                              const MaterialLaw law)
    : law_(law)
    , matrices_(element)
    , values_(*element.mapping,
              *element.scalar,
              element.quadrature,
              dealii::update_gradients | dealii::update_JxW_values)
  {}

  template <int dim>
  Tensor<dim>
  CellEnergy<dim>::deformation_gradient(const Eigen::MatrixXd &displacement,
                                        const unsigned int q) const
  {
    Tensor<dim> F = Tensor<dim>::Identity();
    for (const unsigned int a : values_.dof_indices())
      for (int d = 0; d < dim; ++d)
        F.col(d) += values_.shape_grad(a, q)[d] * displacement.col(a);
    return F;
  }

  template <int dim>
  std::optional<EnergyTerm>
  CellEnergy<dim>::evaluate(const Cell &cell,
                            const CellMaterial &material,
                            const Eigen::MatrixXd &displacement)
  {
    if (law_ != MaterialLaw::linear)
      return evaluate_hyperelastic(cell, material, displacement);
    EnergyTerm term;
    for (const unsigned int v : cell->vertex_indices())
      term.nodes.push_back(cell->vertex_index(v));
    term.hessian  = matrices_.stiffness(cell, material);
    term.gradient = term.hessian * displacement.reshaped();
    term.energy   = 0.5 * term.gradient.dot(displacement.reshaped());
    return term;
  }

  template <int dim>
  std::optional<EnergyTerm>
  CellEnergy<dim>::evaluate_hyperelastic(const Cell &cell,
                                         const CellMaterial &material,
                                         const Eigen::MatrixXd &displacement)
  {
    values_.reinit(cell);
    const unsigned int n = values_.dofs_per_cell;
    EnergyTerm term;
    for (const unsigned int v : cell->vertex_indices())
      term.nodes.push_back(cell->vertex_index(v));
    term.energy   = 0.;
    term.gradient = Eigen::VectorXd::Zero(dim * n);
    term.hessian  = Eigen::MatrixXd::Zero(dim * n, dim * n);

    Eigen::MatrixXd gradients(dim, n);
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        const Tensor<dim> F = deformation_gradient(displacement, q);
        const auto state    = material_state<dim>(law_, F, material);
        if (!state)
          return {};
        for (unsigned int a = 0; a < n; ++a)
          for (int d = 0; d < dim; ++d)
            gradients(d, a) = values_.shape_grad(a, q)[d];

        const double weight     = values_.JxW(q) * material.thickness;
        const Eigen::MatrixXd B = strain_gradients<dim>(F, gradients);
        const Eigen::MatrixXd forces =
          weight * F * state->stress * gradients; // dim x n
        const Eigen::MatrixXd stress_stiffness =
          weight * gradients.transpose() * state->stress * gradients;

        term.energy += weight * state->energy;
        term.gradient += forces.reshaped();
        term.hessian += weight * B.transpose() * state->tangent * B;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            for (int d = 0; d < dim; ++d)
              term.hessian(dim * a + d, dim * b + d) += stress_stiffness(a, b);
      }
    return term;
  }

  template <int dim>
  double
  CellEnergy<dim>::smallest_jacobian(const Cell &cell,
                                     const Eigen::MatrixXd &displacement)
  {
    values_.reinit(cell);
    double smallest = std::numeric_limits<double>::max();
    for (const unsigned int q : values_.quadrature_point_indices())
      smallest =
        std::min(smallest, deformation_gradient(displacement, q).determinant());
    return smallest;
  }

  template class CellEnergy<2>;
  template class CellEnergy<3>;
} // namespace springfit
