#include <springfit/reference/cell_energy.h>
#include <springfit/reference/cell_frame.h>
#include <springfit/reference/membrane_state.h>

#include <Eigen/Geometry>
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

    std::optional<MembraneState>
    material_state(const MaterialLaw law,
                   const Eigen::Matrix<double, 3, 2> &F,
                   const CellMaterial &material)
    {
      return membrane_state(
        [&](const Eigen::Matrix2d &U) {
          return material_state<2>(law, U, material);
        },
        F);
    }

    template <int dim>
    double
    jacobian(const Tensor<dim> &F)
    {
      return F.determinant();
    }

    double
    jacobian(const Eigen::Matrix<double, 3, 2> &F)
    {
      return F.col(0).cross(F.col(1)).norm();
    }
  } // namespace

  template <int dim, int spacedim>
  CellEnergy<dim, spacedim>::CellEnergy(const Element<dim, spacedim> &element,
                                        const MaterialLaw law)
    : law_(law)
    , matrices_(element)
    , values_(*element.mapping,
              *element.scalar,
              element.quadrature,
              dealii::update_gradients | dealii::update_JxW_values)
  {}

  template <int dim, int spacedim>
  Eigen::MatrixXd
  CellEnergy<dim, spacedim>::gradients(const Frame &frame,
                                       const unsigned int q) const
  {
    Eigen::MatrixXd gradients(spacedim, values_.dofs_per_cell);
    for (const unsigned int a : values_.dof_indices())
      for (int d = 0; d < spacedim; ++d)
        gradients(d, a) = values_.shape_grad(a, q)[d];
    if constexpr (dim == spacedim)
      return gradients;
    else
      return frame.transpose() * gradients;
  }

  template <int dim, int spacedim>
  std::optional<EnergyTerm>
  CellEnergy<dim, spacedim>::evaluate(const Cell &cell,
                                      const CellMaterial &material,
                                      const Eigen::MatrixXd &displacement)
  {
    if (law_ != MaterialLaw::linear)
      return evaluate_hyperelastic(cell, material, displacement);
    EnergyTerm term;
    for (const unsigned int v : cell->vertex_indices())
      term.nodes.push_back(cell->vertex_index(v));
    term.hessian  = in_space<dim, spacedim>(cell_frame<dim, spacedim>(cell),
                                           matrices_.stiffness(cell, material));
    term.gradient = term.hessian * displacement.reshaped();
    term.energy   = 0.5 * term.gradient.dot(displacement.reshaped());
    return term;
  }

  template <int dim, int spacedim>
  std::optional<EnergyTerm>
  CellEnergy<dim, spacedim>::evaluate_hyperelastic(
    const Cell &cell,
    const CellMaterial &material,
    const Eigen::MatrixXd &displacement)
  {
    values_.reinit(cell);
    const Frame frame    = cell_frame<dim, spacedim>(cell);
    const unsigned int n = values_.dofs_per_cell;
    EnergyTerm term;
    for (const unsigned int v : cell->vertex_indices())
      term.nodes.push_back(cell->vertex_index(v));
    term.energy   = 0.;
    term.gradient = Eigen::VectorXd::Zero(spacedim * n);
    term.hessian  = Eigen::MatrixXd::Zero(spacedim * n, spacedim * n);

    // G: the change of F, in columns, is G delta u.
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(spacedim * dim, spacedim * n);
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        const Eigen::MatrixXd g = gradients(frame, q);
        const Frame F           = frame + displacement * g.transpose();
        const auto state        = material_state(law_, F, material);
        if (!state)
          return {};
        for (unsigned int a = 0; a < n; ++a)
          for (int i = 0; i < spacedim; ++i)
            for (int k = 0; k < dim; ++k)
              G(i + spacedim * k, spacedim * a + i) = g(k, a);

        const double weight = values_.JxW(q) * material.thickness;
        term.energy += weight * state->energy;
        term.gradient += weight * G.transpose() * state->stress.reshaped();
        term.hessian += weight * G.transpose() * state->tangent * G;
      }
    return term;
  }

  template <int dim, int spacedim>
  double
  CellEnergy<dim, spacedim>::smallest_jacobian(
    const Cell &cell,
    const Eigen::MatrixXd &displacement)
  {
    values_.reinit(cell);
    const Frame frame = cell_frame<dim, spacedim>(cell);
    double smallest   = std::numeric_limits<double>::max();
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        const Frame F = frame + displacement * gradients(frame, q).transpose();
        smallest      = std::min(smallest, jacobian(F));
      }
    return smallest;
  }

  template class CellEnergy<2>;
  template class CellEnergy<2, 3>;
  template class CellEnergy<3>;
} // namespace springfit
