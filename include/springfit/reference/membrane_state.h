#ifndef springfit_reference_membrane_state_h
#define springfit_reference_membrane_state_h

#include <springfit/reference/material_law.h>

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace springfit
{
  /**
   * The state of a membrane at a point, of a deformation gradient F (3 x 2)
   * that maps its plane into space: see MaterialState.
   */
  struct MembraneState
  {
    double energy;                       // J/m^3
    Eigen::Matrix<double, 3, 2> stress;  // P, Pa
    Eigen::Matrix<double, 6, 6> tangent; // dP/dF, Pa
  };

  /** The state of an isotropic material in the plane; nothing: it has none. */
  using PlaneLaw =
    std::function<std::optional<MaterialState<2>>(const Eigen::Matrix2d &F)>;

  /**
   * A law of the plane in the tangent plane of a membrane. A change of F out of
   * that plane turns it, and with it, as the law is objective, the stress.
   *
   * Nothing where the law has no state, or where F is not of rank 2: there the
   * membrane has no tangent plane.
   */
  std::optional<MembraneState>
  membrane_state(const PlaneLaw &law, const Eigen::Matrix<double, 3, 2> &F);
} // namespace springfit

#endif
