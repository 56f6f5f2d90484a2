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
#include <vector>

namespace springfit
{
  /** What the energy of a cell needs of its shape at rest. */
  template <int dim, int spacedim>
  struct RestShape
  {
    /** See cell_frame(). */
    Eigen::Matrix<double, spacedim, dim> frame;

    /**
     * At each quadrature point those of all shape functions in the coordinates
     * of the cell, in columns, 1/m.
     */
    std::vector<Eigen::Matrix<double, dim, Eigen::Dynamic>> gradients;

    std::vector<double> weights; // m^dim
  };

  /**
   * The elastic energy of single cells, with the quadrature of their linear
   * stiffness, total Lagrangian (Bonet and Wood 2008, chapter 9).
   *
   * There is none where the law has no energy: of the neo-Hookean law, where
   * material is turned inside out; on surfaces in space, of all laws but the
   * linear one, where a cell has no area.
   */
  template <int dim, int spacedim = dim>
  class CellEnergy
  {
  public:
    using Cell =
      typename dealii::Triangulation<dim, spacedim>::active_cell_iterator;
    using Shape = RestShape<dim, spacedim>;

    explicit CellEnergy(const Element<dim, spacedim> &element);

    Shape
    rest_shape(const Cell &cell);

    /**
     * Of any law.
     *
     * @param displacement of the element's nodes, spacedim x n, m
     * @return a term whose nodes are left to the caller
     */
    std::optional<EnergyTerm>
    evaluate(MaterialLaw law,
             const Cell &cell,
             const CellMaterial &material,
             const Eigen::MatrixXd &displacement);

    /** The smallest det F at the quadrature points; of surfaces in space the
     * ratio of areas.
     */
    double
    smallest_jacobian(const Cell &cell, const Eigen::MatrixXd &displacement);

  private:
    CellMatrices<dim, spacedim> matrices_;
    dealii::FEValues<dim, spacedim> values_;
  };

  // Of laws that are not linear.

  /** J */
  template <int dim, int spacedim>
  std::optional<double>
  energy(const RestShape<dim, spacedim> &shape,
         MaterialLaw law,
         const CellMaterial &material,
         const Eigen::MatrixXd &displacement);

  /** Its gradient, N, spacedim x n: the forces that hold the state. */
  template <int dim, int spacedim>
  std::optional<Eigen::MatrixXd>
  energy_gradient(const RestShape<dim, spacedim> &shape,
                  MaterialLaw law,
                  const CellMaterial &material,
                  const Eigen::MatrixXd &displacement);

  /** All of it; the nodes are left to the caller. */
  template <int dim, int spacedim>
  std::optional<EnergyTerm>
  energy_term(const RestShape<dim, spacedim> &shape,
              MaterialLaw law,
              const CellMaterial &material,
              const Eigen::MatrixXd &displacement);
} // namespace springfit

#endif
