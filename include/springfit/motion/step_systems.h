#ifndef springfit_motion_step_systems_h
#define springfit_motion_step_systems_h

#include <springfit/motion/moving_body.h>
#include <springfit/motion/step_system.h>

#include <memory>
#include <string>

namespace springfit
{
  /** A way to solve the steps of a body, and why it is the one. */
  struct ChosenStepSystem
  {
    std::unique_ptr<StepSystem> system;

    /** A sentence for the log. */
    std::string reason;
  };

  /**
   * The system that is fastest as far as the body's nodes and the pairs of them
   * that springs or cells join tell: factors of each step's matrix where these
   * are cheap, as of small bodies and of membranes, whose nodes hardly resist
   * in some direction; else conjugate gradients, with factors of the matrix at
   * rest where these have few entries, as of slender bodies, or of large
   * membranes, and a multigrid method elsewhere.
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
