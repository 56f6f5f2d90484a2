#ifndef springfit_comparison_bending_ratio_h
#define springfit_comparison_bending_ratio_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * How many times too stiff a quadrilateral or a hexahedron is in bending: the
   * energy of its stiffness in the displacements u_a = - x_a x_b, u_b =
   * x_a^2 / 2 of its vertices, relative to the energy E x_b^2 / 2 of a bent
   * beam, the largest over the pairs of its directions a and b. A square of
   * plane stress with nu = 0 has 1.5. What is much more is locking: shear that
   * bending has not, in flat cells, or pressure that it has not, near nu = 1/2
   * (Hughes 2000, The finite element method, sections 4.4 and 5.4).
   *
   * @param points vertices, dim x n, m
   * @param stiffness (dim n) x (dim n), N/m
   * @param modulus E of a beam of the material, times the thickness in 2-d
   * (N/m, Pa): in plane strain E / (1 - nu^2)
   */
  double
  bending_ratio(const Eigen::MatrixXd &points,
                CellKind kind,
                const Eigen::MatrixXd &stiffness,
                double modulus);
} // namespace springfit

#endif
