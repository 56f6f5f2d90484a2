#ifndef springfit_comparison_uniaxial_test_h
#define springfit_comparison_uniaxial_test_h

#include <springfit/comparison/homogenised_tensor.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  // A single cell, given by its vertices, dim x n_nodes in m, by a stiffness
  // K in N/m, be it that of finite elements, of springs or of anything else
  // (component d of vertex v is row dim * v + d), and by the integrals of its
  // shape functions' gradients, dim x n_nodes in m^2 (in 2-d times the
  // thickness). The gradients' product with the vertices is the volume.

  /**
   * A tensile test of a free cell: Young's modulus and Poisson's ratio as a
   * uniform uniaxial stress along @p axis (a unit vector) finds them.
   *
   * The stress s a a^T acts as its tractions on all of the boundary, of a box
   * pulled along an edge on the two ends alone, with the nodal forces
   * f_v = s a (a . integral of grad N_v), which are in equilibrium: supports
   * need only to remove the rigid motions, so that the minimum-norm solution of
   * K u = f serves, and the lateral contraction is free. With the mean
   * displacement gradient G, E = s / (a . G a) and nu is the negative ratio of
   * the mean lateral and the axial strain.
   *
   * In 2-d both are the apparent constants of the plane, see
   * from_plane_strain().
   *
   * Nothing where there is nothing to measure: the cell gives way to the
   * stress without resistance, or is not strained along the axis.
   */
  std::optional<YoungPoisson>
  uniaxial_test(const Eigen::MatrixXd &stiffness,
                const Eigen::MatrixXd &points,
                const Eigen::MatrixXd &integrated_gradients,
                const Eigen::VectorXd &axis);

  /**
   * The elasticity tensor of a cell under affine displacements u = G x, from
   * its energy V G : C : G / 2. For springs it is homogenised_tensor() of the
   * body that repeats the cell, for a finite element that of its material.
   */
  ElasticityTensor
  affine_tensor(const Eigen::MatrixXd &stiffness,
                const Eigen::MatrixXd &points,
                const Eigen::MatrixXd &integrated_gradients);
} // namespace springfit

#endif
