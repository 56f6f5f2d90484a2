#ifndef springfit_reference_cell_matrices_h
#define springfit_reference_cell_matrices_h

#include <springfit/reference/element.h>
#include <springfit/reference/material.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * The finite element matrices of single cells, in their own coordinates (see
   * cell_frame.h). Degree of freedom dim * v + d is component d of vertex v.
   */
  template <int dim, int spacedim = dim>
  class CellMatrices
  {
  public:
    using Cell =
      typename dealii::Triangulation<dim, spacedim>::active_cell_iterator;

    explicit CellMatrices(const Element<dim, spacedim> &element);

    /**
     * The stiffness R = integral of B^T D B of linear isotropic elasticity in
     * N/m, (dim n_vertices) x (dim n_vertices); of cells of dimension 2 times
     * the thickness.
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
    dealii::FEValues<dim, spacedim> values_;
    dealii::FEValues<dim, spacedim> nodal_values_;
  };


  /**
   * The matrix of a cell, (spacedim n_vertices) x (spacedim n_vertices), whose
   * matrix in its own coordinates is @p flat.
   *
   * @param frame see cell_frame.h
   */
  template <int dim, int spacedim>
  Eigen::MatrixXd
  in_space(const Eigen::Matrix<double, spacedim, dim> &frame,
           const Eigen::MatrixXd &flat);
} // namespace springfit

#endif
