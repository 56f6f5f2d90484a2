#ifndef springfit_motion_step_systems_h
#define springfit_motion_step_systems_h

#include <springfit/motion/iterative_step_system.h>
#include <springfit/motion/moving_body.h>

#include <memory>
#include <string>

namespace springfit
{
  /** A way to solve the steps of a body, and why it is the one. */
  struct ChosenStepSystem
  {
    std::unique_ptr<IterativeStepSystem> system;

    /** A sentence for the log. */
    std::string reason;
  };

  /**
   * The system that is fastest as far as the body's nodes and the pairs of them
   * that springs or cells join tell: conjugate gradients, with factors of the
   * matrix at rest where these have few entries, as of small or slender bodies,
   * or where nodes hardly resist in some direction, as those of membranes, and
   * a multigrid method elsewhere.
   *
   * @param body must outlive the system
   * @param tolerance for the residual of a solution, relative to the forces
   */
  ChosenStepSystem
  make_step_system(int dim,
                   const MovingBody &body,
                   double tolerance      = 1e-6,
                   WhereIndefinite where = WhereIndefinite::factors);
} // namespace springfit

#endif
