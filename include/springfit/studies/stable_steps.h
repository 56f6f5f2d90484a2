#ifndef springfit_studies_stable_steps_h
#define springfit_studies_stable_steps_h

#include <springfit/core/session.h>
#include <springfit/studies/calibrated_scene.h>

namespace springfit
{
  /**
   * Say and write into stable_steps.csv the largest step with which symplectic
   * Euler's method is stable for each network and for the linear finite
   * elements, at rest and with the damping of section Dynamics, beside the
   * bound that only the springs' stiffness and the masses tell. Nothing is
   * held: supports make the step only larger.
   */
  template <int dim, int spacedim>
  void
  tell_stable_steps(const Scene<spacedim> &scene,
                    const CalibratedScene<dim, spacedim> &calibrated,
                    Session &session);
} // namespace springfit

#endif
