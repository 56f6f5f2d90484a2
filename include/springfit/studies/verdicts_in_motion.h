#ifndef springfit_studies_verdicts_in_motion_h
#define springfit_studies_verdicts_in_motion_h

#include <springfit/studies/judged_body.h>

#include <cstdint>

namespace springfit
{
  // What is wrong with a model is in the row, and not thrown, but for RunErrors
  // of models that cannot be made.

  /**
   * From a state whose free node nearest to the middle is pushed along the
   * first direction, by so many of its longest edges: whether implicit Euler's
   * method comes back to rest within @p n_steps steps, 500 at most.
   */
  template <int dim, int spacedim>
  void
  judge_inverted(const JudgedBody<dim, spacedim> &body,
                 double edges,
                 std::uint64_t n_steps,
                 StabilityRow &row);

  /**
   * Under the first load case, by a method with a given step, s, of which
   * implicit ones do 200 steps at most.
   */
  template <int dim, int spacedim>
  void
  judge_motion(const JudgedBody<dim, spacedim> &body,
               Integrator integrator,
               double step,
               std::uint64_t most_steps,
               StabilityRow &row);
} // namespace springfit

#endif
