#ifndef springfit_fit_displacement_fields_h
#define springfit_fit_displacement_fields_h

#include <Eigen/Core>

namespace springfit
{
  // Vectors at nodes (dim x n_nodes, m), displacements or forces, as columns;
  // row dim * v + d is component d of node v. Coordinates are relative to the
  // mean of the nodes and to their largest distance from it in a coordinate, so
  // that the fields have no unit and are of size one. Shears and products of
  // two different coordinates weigh sqrt(2), so that no axes are preferred.

  /**
   * The constant strains, dim (dim + 1) / 2 of them: the normal ones along the
   * axes, then the shears.
   */
  Eigen::MatrixXd
  affine_fields(const Eigen::MatrixXd &nodes);

  /**
   * Each product of two coordinates in each direction, dim^2 (dim + 1) / 2 of
   * them: bending, torsion, gradients of strain.
   */
  Eigen::MatrixXd
  quadratic_fields(const Eigen::MatrixXd &nodes);
} // namespace springfit

#endif
