#ifndef springfit_reference_cell_energy_h
#define springfit_reference_cell_energy_h

#include <springfit/core/energy_term.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/reference/material_law.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * The elastic energy of single cells, with the quadrature of their linear
   * stiffness, total Lagrangian (Bonet and Wood 2008, chapter 9).
   */
  template <int dim>
  class CellEnergy
  {
  public:
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    CellEnergy(const Element<dim> &element, MaterialLaw law);

    /**
     * @param displacement dim x n_vertices, m
     * @return nothing where the law has no energy: of the neo-Hookean law,
     * where material is turned inside out.
     */
    std::optional<EnergyTerm>
    evaluate(const Cell &cell,
             const CellMaterial &material,
             const Eigen::MatrixXd &displacement);

    /** The smallest det F at the quadrature points. */
    double
    smallest_jacobian(const Cell &cell, const Eigen::MatrixXd &displacement);

  private:
    std::optional<EnergyTerm>
    evaluate_hyperelastic(const Cell &cell,
                          const CellMaterial &material,
                          const Eigen::MatrixXd &displacement);

    /** F at a quadrature point of the cell that the values stand on. */
    Eigen::Matrix<double, dim, dim>
    deformation_gradient(const Eigen::MatrixXd &displacement,
                         unsigned int q) const;

    const MaterialLaw law_;
    CellMatrices<dim> matrices_;
    dealii::FEValues<dim> values_;
  };
} // namespace springfit

#endif
