#ifndef springfit_fit_cell_finite_element_stiffness_h
#define springfit_fit_cell_finite_element_stiffness_h

#include <springfit/core/cell_kind.h>
#include <springfit/fit/cell_material.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * R of a P1 or Q1 element without a mesh: the tangent at rest of the springs
   * and point volumes that are the element, see stable_neo_hookean.h.
   *
   * @param points dim x n_nodes, m, in deal.II's numbering: of quadrilaterals
   * and hexahedra lexicographic, x fastest; the cell's volume is positive
   * @return (dim * n_nodes) x (dim * n_nodes), N/m; row dim * v + d for
   * component d of vertex v
   */
  Eigen::MatrixXd
  finite_element_stiffness(const Eigen::MatrixXd &points,
                           CellKind kind,
                           const IsotropicMaterial &material);
} // namespace springfit

#endif
