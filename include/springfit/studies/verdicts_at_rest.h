#ifndef springfit_studies_verdicts_at_rest_h
#define springfit_studies_verdicts_at_rest_h

#include <springfit/studies/judged_body.h>

#include <cstdint>

namespace springfit
{
  // What is wrong with a model is in the row, and not thrown, but for RunErrors
  // of models that cannot be made.

  /**
   * At rest: the spectrum of the held body, the stable step that is predicted
   * and the one that motions of @p n_steps steps show, and statics under all
   * load cases.
   */
  template <int dim, int spacedim>
  void
  judge_at_rest(const JudgedBody<dim, spacedim> &body,
                std::uint64_t n_steps,
                StabilityRow &row);

  /**
   * In equilibrium between its two ends along its longest direction, which are
   * held @p stretch times as far apart as at rest.
   */
  template <int dim, int spacedim>
  void
  judge_stretched(const JudgedBody<dim, spacedim> &body,
                  double stretch,
                  StabilityRow &row);
} // namespace springfit

#endif
