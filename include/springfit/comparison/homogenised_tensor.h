#ifndef springfit_comparison_homogenised_tensor_h
#define springfit_comparison_homogenised_tensor_h

#include <springfit/springs/network.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * An elasticity tensor C_ijkl in Pa as a matrix (dim^2 x dim^2): row
   * dim * i + j, column dim * k + l.
   */
  using ElasticityTensor = Eigen::MatrixXd;

  /**
   * The tensor of a network under affine deformation u_i = H_ij x_j: the second
   * derivative of its energy by H, divided by @p volume in m^3 (in 2-d area
   * times thickness), the springs' tension at rest included. Of springs at rest
   * it is C_ijkl = (1 / V) sum_s k_s L_s^2 n_i n_j n_k n_l (Born and Huang
   * 1954), symmetric in all four indices (Cauchy's relations), whatever their
   * constants.
   */
  ElasticityTensor
  homogenised_tensor(const SpringNetwork &network, double volume);


  /** The isotropic tensor nearest to a given one in the Frobenius norm. */
  struct IsotropicPart
  {
    double lambda;     // Pa, of the space of the tensor (2-d or 3-d)
    double mu;         // Pa
    double anisotropy; // distance from the tensor, relative to its norm
  };

  IsotropicPart
  isotropic_part(const ElasticityTensor &tensor);


  /** Young's modulus in Pa and Poisson's ratio. */
  struct YoungPoisson
  {
    double youngs_modulus;
    double poissons_ratio;
  };

  /** 3-d, and plane strain. */
  YoungPoisson
  young_poisson(double lambda, double mu);

  YoungPoisson
  young_poisson_plane_stress(double lambda, double mu);

  /**
   * The constants of a material of which a test in plane strain shows the
   * @p apparent ones, E / (1 - nu^2) and nu / (1 - nu).
   */
  YoungPoisson
  from_plane_strain(const YoungPoisson &apparent);
} // namespace springfit

#endif
