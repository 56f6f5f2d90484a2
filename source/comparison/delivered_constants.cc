#include <springfit/comparison/delivered_constants.h>
#include <springfit/comparison/slab_share.h>
#include <springfit/reference/cell_frame.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace springfit
{
  namespace
  {
    template <int spacedim>
    Interval
    extent_along(const Eigen::VectorXd &axis,
                 const std::vector<dealii::Point<spacedim>> &vertices)
    {
      Interval extent{1e300, -1e300};
      for (const auto &vertex : vertices)
        {
          double position = 0.;
          for (int d = 0; d < spacedim; ++d)
            position += axis[d] * vertex[d];
          extent.lowest  = std::min(extent.lowest, position);
          extent.highest = std::max(extent.highest, position);
        }
      return extent;
    }

    /** Where to measure: see delivered_constants. */
    template <int dim, int spacedim>
    Interval
    measured_part(const Mesh<dim, spacedim> &mesh,
                  const Eigen::VectorXd &axis,
                  const Interval &object)
    {
      constexpr double parallel = 1. - 1e-9; // to x, either way
      if (mesh.straight_part && std::abs(axis[0]) > parallel)
        return axis[0] > 0. ? *mesh.straight_part
                            : Interval{-mesh.straight_part->highest,
                                       -mesh.straight_part->lowest};
      return {object.lowest + object.length() / 3.,
              object.highest - object.length() / 3.};
    }
  } // namespace

  template <int dim, int spacedim>
  std::optional<YoungPoisson>
  delivered_constants(const Mesh<dim, spacedim> &mesh,
                      const Element<dim, spacedim> &element,
                      const Eigen::VectorXd &axis,
                      const Eigen::MatrixXd &displacement,
                      const Eigen::MatrixXd &forces,
                      const double thickness)
  {
    const Interval object =
      extent_along(axis, mesh.triangulation.get_vertices());
    const Interval part = measured_part(mesh, axis, object);

    dealii::FEValues<dim, spacedim> values(*element.mapping,
                                           *element.scalar,
                                           element.quadrature,
                                           dealii::update_gradients |
                                             dealii::update_JxW_values);
    double volume            = 0.;
    Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(spacedim, spacedim);
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const double share = slab_share(cell_points<dim, spacedim>(cell),
                                        mesh.cell_kind,
                                        axis,
                                        part.lowest,
                                        part.highest);
        if (share == 0.)
          continue;
        values.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const double weight = share * values.JxW(q);
            volume += weight;
            for (const unsigned int a : values.dof_indices())
              for (int d = 0; d < spacedim; ++d)
                gradient.col(d) += weight * values.shape_grad(a, q)[d] *
                                   displacement.col(cell->vertex_index(a));
          }
      }
    if (volume == 0.)
      return {};
    gradient /= volume;

    const double axial   = axis.dot(gradient * axis);
    const double lateral = (gradient.trace() - axial) / (dim - 1);
    const double force   = axis.dot(forces.rowwise().sum());
    const double area    = thickness * volume / part.length();
    const double strained =
      displacement.colwise().norm().maxCoeff() / object.length();
    if (std::abs(axial) <= 1e-9 * strained)
      return {};
    return YoungPoisson{force / area / axial, -lateral / axial};
  }

  template std::optional<YoungPoisson>
  delivered_constants<2>(const Mesh<2> &,
                         const Element<2> &,
                         const Eigen::VectorXd &,
                         const Eigen::MatrixXd &,
                         const Eigen::MatrixXd &,
                         double);
  template std::optional<YoungPoisson>
  delivered_constants<2, 3>(const Mesh<2, 3> &,
                            const Element<2, 3> &,
                            const Eigen::VectorXd &,
                            const Eigen::MatrixXd &,
                            const Eigen::MatrixXd &,
                            double);
  template std::optional<YoungPoisson>
  delivered_constants<3>(const Mesh<3> &,
                         const Element<3> &,
                         const Eigen::VectorXd &,
                         const Eigen::MatrixXd &,
                         const Eigen::MatrixXd &,
                         double);
} // namespace springfit
