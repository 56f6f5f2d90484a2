#ifndef springfit_motion_energy_account_h
#define springfit_motion_energy_account_h

#include <springfit/motion/moving_body.h>

#include <Eigen/Core>

namespace springfit
{
  /** What went into a motion and out of it since its beginning, J. */
  struct EnergyAccount
  {
    double work_of_loads    = 0.;
    double work_of_contact  = 0.;
    double work_of_supports = 0.;
    double dissipated       = 0.; // by Rayleigh's damping and dampers
  };


  /** The forces in a state, N, dim x n_nodes. */
  struct ForcesInMotion
  {
    Eigen::MatrixXd loads;   // without obstacles
    Eigen::MatrixXd contact; // of all obstacles
    Eigen::MatrixXd damping; // C v

    /** Of the supports on the body; 0 where it is free. */
    Eigen::MatrixXd reactions;
  };

  /** C v with the tangent stiffness at the state, N, dim x n_nodes. */
  Eigen::MatrixXd
  damping_forces(const MovingBody &body, const MotionState &state);

  /**
   * What the supports must exert for the body to move as it does: M a + C v +
   * grad U - loads where it is held, 0 elsewhere.
   *
   * @param acceleration m/s^2, dim x n_nodes
   */
  Eigen::MatrixXd
  reactions_in_motion(const MovingBody &body,
                      const MotionState &state,
                      const Eigen::MatrixXd &acceleration);

  /** Add a step from one state to the next, by the trapezoidal rule. */
  void
  add_step(const MotionState &before,
           const ForcesInMotion &forces_before,
           const MotionState &after,
           const ForcesInMotion &forces_after,
           EnergyAccount &account);
} // namespace springfit

#endif
