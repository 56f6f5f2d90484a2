#ifndef springfit_core_plane_stress_h
#define springfit_core_plane_stress_h

#include <optional>

namespace springfit
{
  /**
   * The square c of the stretch across a sheet of a neo-Hookean material,
   * energy mu (tr C - 3 - 2 ln J) / 2 + lambda (ln J)^2 / 2, that has no
   * stress there: mu (c - 1) + lambda ln J = 0 with J = J_plane sqrt(c).
   *
   * @param log_J_plane ln of the ratio of deformed area to area at rest
   * @param lambda_plane 2 lambda mu / (lambda + 2 mu) in Pa, the first Lame
   * constant in plane stress; 2 mu is the limit nu = 0.5, in which J = 1.
   * @param mu Pa
   * @return nothing where there is no such stretch: for nu < 0 under much
   * compression.
   */
  std::optional<double>
  squared_stretch_across(double log_J_plane, double lambda_plane, double mu);
} // namespace springfit

#endif
