#include <springfit/reference/cell_energy.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <stdexcept>

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
      switch (law)
        {
          case MaterialLaw::st_venant_kirchhoff:
            return st_venant_kirchhoff<dim>(F, material.lame);
          case MaterialLaw::neo_hookean:
            return neo_hookean_of<dim>(F, material);
          case MaterialLaw::stable_neo_hookean:
            return stable_neo_hookean<dim>(F, material.lame);
          case MaterialLaw::linear:
            break;
        }
      throw std::logic_error("the linear law has no hyperelastic state");
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

    // G: the change of F, in columns, is G delta u.
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(dim * dim, dim * n);
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        const auto state =
          material_state<dim>(law_,
                              deformation_gradient(displacement, q),
                              material);
        if (!state)
          return {};
        for (unsigned int a = 0; a < n; ++a)
          for (int i = 0; i < dim; ++i)
            for (int k = 0; k < dim; ++k)
              G(i + dim * k, dim * a + i) = values_.shape_grad(a, q)[k];

        const double weight = values_.JxW(q) * material.thickness;
        term.energy += weight * state->energy;
        term.gradient += weight * G.transpose() * state->stress.reshaped();
        term.hessian += weight * G.transpose() * state->tangent * G;
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
