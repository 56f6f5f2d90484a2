#ifndef springfit_motion_meet_obstacles_h
#define springfit_motion_meet_obstacles_h

#include <springfit/motion/moving_body.h>
#include <springfit/motion/step_system.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * The velocity @p y (dim x n_nodes, m/s) at the end of a step from the state
   * @p begin, whose loads were linearised there, made such that the loads are
   * those at its end: a node that meets or leaves an obstacle on the way would
   * otherwise be found far inside it, or held back from outside. This is
   * Newton's method on what the step's linear equations and the loads leave
   * over.
   *
   * @param norm of all impulses of the step, N s
   * @param tolerance for those left over, relative to it
   */
  void
  meet_obstacles(const MovingBody &body,
                 StepSystem &system,
                 const StepFactors &factors,
                 double norm,
                 double tolerance,
                 double step,
                 const MotionState &begin,
                 Eigen::MatrixXd &y);
} // namespace springfit

#endif
