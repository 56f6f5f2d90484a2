#ifndef springfit_reference_cell_frame_h
#define springfit_reference_cell_frame_h

#include <deal.II/grid/tria.h>

#include <Eigen/Core>

namespace springfit
{
  /** The vertices of a cell in m, spacedim x n_vertices. */
  template <int dim, int spacedim = dim>
  Eigen::MatrixXd
  cell_points(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell);

  /**
   * The orthonormal vectors, in columns, along which the coordinates of a cell
   * run: the axes; of a triangle in space its first edge and the vector in its
   * plane that makes it counter-clockwise.
   */
  template <int dim, int spacedim = dim>
  Eigen::Matrix<double, spacedim, dim>
  cell_frame(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell);

  /**
   * The vertices of a cell in its own coordinates, m, dim x n_vertices: a
   * triangle in space laid flat. Of a body they are cell_points().
   */
  template <int dim, int spacedim = dim>
  Eigen::MatrixXd
  flat_points(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell);
} // namespace springfit

#endif
