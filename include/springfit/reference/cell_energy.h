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
  template <int dim, int spacedim = dim>
  class CellEnergy
  {
  public:
    using Cell =
      typename dealii::Triangulation<dim, spacedim>::active_cell_iterator;

    CellEnergy(const Element<dim, spacedim> &element, MaterialLaw law);

    /**
     * @param displacement spacedim x n_vertices, m
     * @return nothing where the law has no energy: of the neo-Hookean law,
     * where material is turned inside out; on surfaces in space, of all laws
     * but the linear one, where a cell has no area.
     */
    std::optional<EnergyTerm>
    evaluate(const Cell &cell,
             const CellMaterial &material,
             const Eigen::MatrixXd &displacement);

    /**
     * The smallest det F at the quadrature points; of surfaces in space the
     * ratio of areas.
     */
    double
    smallest_jacobian(const Cell &cell, const Eigen::MatrixXd &displacement);

  private:
    std::optional<EnergyTerm>
    evaluate_hyperelastic(const Cell &cell,
                          const CellMaterial &material,
                          const Eigen::MatrixXd &displacement);

    using Frame = Eigen::Matrix<double, spacedim, dim>;

    /** Of all shape functions in the coordinates of the cell, in columns. */
    Eigen::MatrixXd
    gradients(const Frame &frame, unsigned int q) const;

    const MaterialLaw law_;
    CellMatrices<dim, spacedim> matrices_;
    dealii::FEValues<dim, spacedim> values_;
  };
} // namespace springfit

#endif
