#ifndef springfit_comparison_delivered_constants_h
#define springfit_comparison_delivered_constants_h

#include <springfit/comparison/homogenised_tensor.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * What a tensile test would say of a model: Young's modulus is the axial
   * force over the cross section's area and the mean axial strain, Poisson's
   * ratio the negative ratio of the mean lateral and the mean axial strain.
   *
   * Strains and the area are means over a part of the object along @p axis (a
   * unit vector): over the mesh's straight part if it has one and the axis is
   * the straight part's, x, else over the middle third. A cell counts by the
   * part of its volume that lies there. (Natsupakpong and Cavusoglu 2010
   * measure on the straight part of their tensile specimen, Table 4.)
   *
   * Nothing where there is nothing to measure: no material in that part, or
   * none that is strained.
   *
   * @param displacement m, spacedim x n_nodes
   * @param forces       N, spacedim x n_nodes, those that pull
   * @param thickness    m in 2-d, 1 in 3-d
   */
  template <int dim, int spacedim>
  std::optional<YoungPoisson>
  delivered_constants(const Mesh<dim, spacedim> &mesh,
                      const Element<dim, spacedim> &element,
                      const Eigen::VectorXd &axis,
                      const Eigen::MatrixXd &displacement,
                      const Eigen::MatrixXd &forces,
                      double thickness);
} // namespace springfit

#endif
