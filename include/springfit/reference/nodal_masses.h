#ifndef springfit_reference_nodal_masses_h
#define springfit_reference_nodal_masses_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>

#include <Eigen/Core>

namespace springfit
{
  /** The lumped masses of all nodes, kg: the sums of CellMatrices::masses. */
  template <int dim, int spacedim>
  Eigen::VectorXd
  nodal_masses(const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               const MaterialTable &materials);
} // namespace springfit

#endif
