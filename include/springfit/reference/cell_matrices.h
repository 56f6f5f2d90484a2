#ifndef springfit_reference_cell_matrices_h
#define springfit_reference_cell_matrices_h

#include <springfit/reference/element.h>
#include <springfit/reference/material.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Core>

namespace springfit
{
  /** The vertices of a cell in m, dim x n_vertices. */
  template <int dim>
  Eigen::MatrixXd
  cell_points(
    const typename dealii::Triangulation<dim>::active_cell_iterator &cell);


  /**
   * The finite element matrices of single cells. Degree of freedom
   * dim * v + d is component d of vertex v.
   */
  template <int dim>
  class CellMatrices
  {
  public:
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    explicit CellMatrices(const Element<dim> &element);

    /**
     * The stiffness R = integral of B^T D B of linear isotropic elasticity in
     * N/m, (dim n_vertices) x (dim n_vertices); in 2-d times the thickness.
     */
    Eigen::MatrixXd
    stiffness(const Cell &cell, const CellMaterial &material);

    /**
     * The lumped masses of the cell's vertices in kg: nodal quadrature, scaled
     * so that the masses sum to the mass of the cell also where the nodal rule
     * does not integrate a distorted cell's volume exactly.
     */
    Eigen::VectorXd
    masses(const Cell &cell, const CellMaterial &material);

    /**
     * The integrals of the shape functions' gradients over the cell,
     * dim x n_vertices, in m^2 (3-d) or m (2-d).
     */
    Eigen::MatrixXd
    integrated_gradients(const Cell &cell);

    /** The volume in m^3 (3-d) or the area in m^2 (2-d). */
    double
    volume(const Cell &cell);

  private:
    dealii::FEValues<dim> values_;
    dealii::FEValues<dim> nodal_values_;
  };
} // namespace springfit

#endif
