#ifndef springfit_reference_consistent_mass_h
#define springfit_reference_consistent_mass_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>

#include <Eigen/SparseCore>

namespace springfit
{
  /**
   * The integrals of the density times N_a N_b, kg, n_nodes x n_nodes, in 2-d
   * times the thickness: the mass of each component of a motion.
   */
  template <int dim, int spacedim>
  Eigen::SparseMatrix<double>
  consistent_mass(const Mesh<dim, spacedim> &mesh,
                  const Element<dim, spacedim> &element,
                  const MaterialTable &materials);
} // namespace springfit

#endif
