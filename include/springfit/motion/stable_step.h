#ifndef springfit_motion_stable_step_h
#define springfit_motion_stable_step_h

#include <springfit/springs/network.h>

#include <Eigen/Core>

namespace springfit
{
  /** Rayleigh's damping C = mass_factor M + stiffness_factor K. */
  struct RayleighDamping
  {
    double mass_factor      = 0.; // 1/s
    double stiffness_factor = 0.; // s
  };

  /** The share of critical damping of a motion of that frequency, rad/s. */
  double
  damping_ratio(const RayleighDamping &damping, double frequency);

  /**
   * The largest step, in s, with which symplectic Euler's method
   *
   *     v += h M^-1 (f(x) - C v),   x += h v
   *
   * is stable for a motion of that frequency (rad/s): 2 (sqrt(1 + z^2) - z) /
   * frequency with the damping ratio z, where the roots of its characteristic
   * polynomial leave the unit circle. Infinite for the frequency 0 without
   * damping.
   */
  double
  stable_step(const RayleighDamping &damping, double frequency);

  /**
   * A bound that costs nothing: 2 / sqrt(2 max_i (sum of k at i) / m_i), in s,
   * of springs between two nodes at rest without tension, from Gershgorin's
   * circles; never above the largest stable step of undamped springs. Those of
   * k < 0, which make it larger, held nodes and other families are passed over.
   */
  double
  spring_bound_of_step(const SpringNetwork &network,
                       const std::vector<bool> &held);
} // namespace springfit

#endif
