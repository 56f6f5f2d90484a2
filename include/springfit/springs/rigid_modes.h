#ifndef springfit_springs_rigid_modes_h
#define springfit_springs_rigid_modes_h

#include <Eigen/Core>

namespace springfit
{
  /**
   * An orthonormal basis of the linearised rigid motions of a set of nodes.
   *
   * @param points dim x n_nodes, dim 2 or 3, neither coincident nor (in 3-d)
   * on one line
   * @return (dim * n_nodes) x 3 in 2-d, x 6 in 3-d
   */
  Eigen::MatrixXd
  rigid_body_modes(const Eigen::MatrixXd &points);

  /**
   * An orthonormal basis of what remains: displacements that deform. A
   * triangle has 3, a quadrilateral 5, a tetrahedron 6, a hexahedron 18.
   */
  Eigen::MatrixXd
  deformation_basis(const Eigen::MatrixXd &points);


  // The deformations in two parts, orthogonal to each other and to the rigid
  // motions.

  /**
   * An orthonormal basis of the affine deformations, those of constant strain:
   * 3 columns in 2-d, 6 in 3-d.
   *
   * @param points not on one line, in 3-d not in one plane
   */
  Eigen::MatrixXd
  affine_basis(const Eigen::MatrixXd &points);

  /**
   * An orthonormal basis of the others, a cell's bending and hourglass modes: a
   * simplex has none, a quadrilateral 2, a hexahedron 12.
   */
  Eigen::MatrixXd
  hourglass_basis(const Eigen::MatrixXd &points);
} // namespace springfit

#endif
