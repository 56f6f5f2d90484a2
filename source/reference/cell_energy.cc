#include <springfit/reference/cell_energy.h>
#include <springfit/reference/cell_frame.h>
#include <springfit/reference/membrane_state.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
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

  namespace
  {
    /** Calls @p f(point, state) at each; whether all have a state. */
    template <int dim, int spacedim, typename F>
    bool
    for_each_state(const RestShape<dim, spacedim> &shape,
                   const MaterialLaw law,
                   const CellMaterial &material,
                   const Eigen::MatrixXd &displacement,
                   const F &f)
    {
      for (std::size_t q = 0; q < shape.weights.size(); ++q)
        {
          const Eigen::Matrix<double, spacedim, dim> F_q =
            shape.frame + displacement * shape.gradients[q].transpose();
          const auto state = material_state(law, F_q, material);
          if (!state)
            return false;
          f(q, *state);
        }
      return true;
    }
  } // namespace

  template <int dim, int spacedim>
  CellEnergy<dim, spacedim>::CellEnergy(const Element<dim, spacedim> &element)
    : matrices_(element)
    , values_(*element.mapping,
              *element.scalar,
              element.quadrature,
              dealii::update_gradients | dealii::update_JxW_values)
  {}

  template <int dim, int spacedim>
  RestShape<dim, spacedim>
  CellEnergy<dim, spacedim>::rest_shape(const Cell &cell)
  {
    values_.reinit(cell);
    Shape shape;
    shape.frame = cell_frame<dim, spacedim>(cell);
    for (const unsigned int q : values_.quadrature_point_indices())
      {
        Eigen::Matrix<double, spacedim, Eigen::Dynamic> gradients(
          spacedim, values_.dofs_per_cell);
        for (const unsigned int a : values_.dof_indices())
          for (int d = 0; d < spacedim; ++d)
            gradients(d, a) = values_.shape_grad(a, q)[d];
        if constexpr (dim == spacedim)
          shape.gradients.push_back(gradients);
        else
          shape.gradients.push_back(shape.frame.transpose() * gradients);
        shape.weights.push_back(values_.JxW(q));
      }
    return shape;
  }

  template <int dim, int spacedim>
  std::optional<EnergyTerm>
  CellEnergy<dim, spacedim>::evaluate(const MaterialLaw law,
                                      const Cell &cell,
                                      const CellMaterial &material,
                                      const Eigen::MatrixXd &displacement)
  {
    if (law != MaterialLaw::linear)
      return energy_term(rest_shape(cell), law, material, displacement);
    EnergyTerm term;
    term.hessian  = in_space<dim, spacedim>(cell_frame<dim, spacedim>(cell),
                                           matrices_.stiffness(cell, material));
    term.gradient = term.hessian * displacement.reshaped();
    term.energy   = 0.5 * term.gradient.dot(displacement.reshaped());
    return term;
  }

  template <int dim, int spacedim>
  double
  CellEnergy<dim, spacedim>::smallest_jacobian(
    const Cell &cell,
    const Eigen::MatrixXd &displacement)
  {
    const Shape shape = rest_shape(cell);
    double smallest   = std::numeric_limits<double>::max();
    for (const auto &gradients : shape.gradients)
      {
        const Eigen::Matrix<double, spacedim, dim> F =
          shape.frame + displacement * gradients.transpose();
        smallest = std::min(smallest, jacobian(F));
      }
    return smallest;
  }

  template <int dim, int spacedim>
  std::optional<double>
  energy(const RestShape<dim, spacedim> &shape,
         const MaterialLaw law,
         const CellMaterial &material,
         const Eigen::MatrixXd &displacement)
  {
    double sum = 0.;
    if (!for_each_state(shape,
                        law,
                        material,
                        displacement,
                        [&](const std::size_t q, const auto &state) {
                          sum += shape.weights[q] * state.energy;
                        }))
      return {};
    return material.thickness * sum;
  }

  template <int dim, int spacedim>
  std::optional<Eigen::MatrixXd>
  energy_gradient(const RestShape<dim, spacedim> &shape,
                  const MaterialLaw law,
                  const CellMaterial &material,
                  const Eigen::MatrixXd &displacement)
  {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(spacedim, displacement.cols());
    if (!for_each_state(shape,
                        law,
                        material,
                        displacement,
                        [&](const std::size_t q, const auto &state) {
                          sum += (shape.weights[q] * material.thickness *
                                  state.stress) *
                                 shape.gradients[q];
                        }))
      return {};
    return sum;
  }

  template <int dim, int spacedim>
  std::optional<EnergyTerm>
  energy_term(const RestShape<dim, spacedim> &shape,
              const MaterialLaw law,
              const CellMaterial &material,
              const Eigen::MatrixXd &displacement)
  {
    const Eigen::Index n = displacement.cols();
    EnergyTerm term;
    term.energy   = 0.;
    term.gradient = Eigen::VectorXd::Zero(spacedim * n);
    term.hessian  = Eigen::MatrixXd::Zero(spacedim * n, spacedim * n);

    // G: the change of F, in columns, is G delta u.
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(spacedim * dim, spacedim * n);
    const auto add    = [&](const std::size_t q, const auto &state) {
      const auto &g = shape.gradients[q];
      for (Eigen::Index a = 0; a < n; ++a)
        for (int i = 0; i < spacedim; ++i)
          for (int k = 0; k < dim; ++k)
            G(i + spacedim * k, spacedim * a + i) = g(k, a);
      const double weight = shape.weights[q] * material.thickness;
      term.energy += weight * state.energy;
      term.gradient += weight * G.transpose() * state.stress.reshaped();
      term.hessian += weight * G.transpose() * state.tangent * G;
    };
    if (!for_each_state(shape, law, material, displacement, add))
      return {};
    return term;
  }

  template class CellEnergy<2>;
  template class CellEnergy<2, 3>;
  template class CellEnergy<3>;
  template std::optional<double>
  energy(const RestShape<2, 2> &,
         MaterialLaw,
         const CellMaterial &,
         const Eigen::MatrixXd &);
  template std::optional<double>
  energy(const RestShape<2, 3> &,
         MaterialLaw,
         const CellMaterial &,
         const Eigen::MatrixXd &);
  template std::optional<double>
  energy(const RestShape<3, 3> &,
         MaterialLaw,
         const CellMaterial &,
         const Eigen::MatrixXd &);
  template std::optional<Eigen::MatrixXd>
  energy_gradient(const RestShape<2, 2> &,
                  MaterialLaw,
                  const CellMaterial &,
                  const Eigen::MatrixXd &);
  template std::optional<Eigen::MatrixXd>
  energy_gradient(const RestShape<2, 3> &,
                  MaterialLaw,
                  const CellMaterial &,
                  const Eigen::MatrixXd &);
  template std::optional<Eigen::MatrixXd>
  energy_gradient(const RestShape<3, 3> &,
                  MaterialLaw,
                  const CellMaterial &,
                  const Eigen::MatrixXd &);
  template std::optional<EnergyTerm>
  energy_term(const RestShape<2, 2> &,
              MaterialLaw,
              const CellMaterial &,
              const Eigen::MatrixXd &);
  template std::optional<EnergyTerm>
  energy_term(const RestShape<2, 3> &,
              MaterialLaw,
              const CellMaterial &,
              const Eigen::MatrixXd &);
  template std::optional<EnergyTerm>
  energy_term(const RestShape<3, 3> &,
              MaterialLaw,
              const CellMaterial &,
              const Eigen::MatrixXd &);
} // namespace springfit
