#ifndef springfit_core_plane_stress_h
#define springfit_core_plane_stress_h

#include <optional>

namespace springfit
{
  /**
   * The square c of the stretch across a plane of the compressible neo-Hookean
   * material of Simo and Pister (1984), such that no stress acts across it: the
   * root of mu (c - 1) + lambda_3 ln J = 0 with ln J = ln J_plane + ln(c) / 2
   * and lambda_3 the first Lame constant in space.
   *
   * @param log_J_plane ln of the change of area in the plane
   * @param lambda the first Lame constant of plane stress, E nu / (1 - nu^2)
   * @param mu shear modulus, in the same unit
   * @return nothing where there is no root: for nu < 0 under much compression
   */
  std::optional<double>
  squared_stretch_across(double log_J_plane, double lambda, double mu);
} // namespace springfit

#endif
