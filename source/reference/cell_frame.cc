#include <springfit/reference/cell_frame.h>

#include <Eigen/Geometry>

namespace springfit
{
  template <int dim, int spacedim>
  Eigen::MatrixXd
  cell_points(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell)
  {
    Eigen::MatrixXd points(spacedim, cell->n_vertices());
    for (const unsigned int v : cell->vertex_indices())
      for (int d = 0; d < spacedim; ++d)
        points(d, v) = cell->vertex(v)[d];
    return points;
  }

  template <int dim, int spacedim>
  Eigen::Matrix<double, spacedim, dim>
  cell_frame(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell)
  {
    if constexpr (dim == spacedim)
      return Eigen::Matrix<double, spacedim, dim>::Identity();
    else
      {
        const Eigen::MatrixXd x = cell_points<dim, spacedim>(cell);
        const Eigen::Vector3d a = (x.col(1) - x.col(0)).normalized();
        const Eigen::Vector3d b = x.col(2) - x.col(0);
        Eigen::Matrix<double, spacedim, dim> frame;
        frame.col(0) = a;
        frame.col(1) = (b - a * a.dot(b)).normalized();
        return frame;
      }
  }

  template <int dim, int spacedim>
  Eigen::MatrixXd
  flat_points(
    const typename dealii::Triangulation<dim, spacedim>::active_cell_iterator
      &cell)
  {
    const Eigen::MatrixXd x = cell_points<dim, spacedim>(cell);
    if constexpr (dim == spacedim)
      return x;
    else
      return cell_frame<dim, spacedim>(cell).transpose() *
             (x.colwise() - x.col(0));
  }

  template Eigen::MatrixXd
  cell_points<2>(const dealii::Triangulation<2>::active_cell_iterator &);
  template Eigen::MatrixXd
  cell_points<2, 3>(const dealii::Triangulation<2, 3>::active_cell_iterator &);
  template Eigen::MatrixXd
  cell_points<3>(const dealii::Triangulation<3>::active_cell_iterator &);
  template Eigen::Matrix<double, 2, 2>
  cell_frame<2>(const dealii::Triangulation<2>::active_cell_iterator &);
  template Eigen::Matrix<double, 3, 2>
  cell_frame<2, 3>(const dealii::Triangulation<2, 3>::active_cell_iterator &);
  template Eigen::Matrix<double, 3, 3>
  cell_frame<3>(const dealii::Triangulation<3>::active_cell_iterator &);
  template Eigen::MatrixXd
  flat_points<2>(const dealii::Triangulation<2>::active_cell_iterator &);
  template Eigen::MatrixXd
  flat_points<2, 3>(const dealii::Triangulation<2, 3>::active_cell_iterator &);
  template Eigen::MatrixXd
  flat_points<3>(const dealii::Triangulation<3>::active_cell_iterator &);
} // namespace springfit
