#ifndef springfit_studies_study_h
#define springfit_studies_study_h

#include <springfit/core/session.h>
#include <springfit/core/words.h>
#include <springfit/studies/scene.h>

namespace springfit
{
  /** What the entry "Study" names. */
  enum class StudyKind
  {
    calibrate,
    compare
  };

  const WordTable<StudyKind> &
  study_words();

  /** Run a study; its results are in the session's output folder afterwards. */
  template <int dim>
  void
  run_study(StudyKind study, const Scene<dim> &scene, Session &session);

  /** Springs for a mesh: constants, masses and what the fits reached. */
  template <int dim>
  void
  calibrate(const Scene<dim> &scene, Session &session);

  /**
   * The springs and the finite elements under the same loads, and how far
   * apart they are.
   */
  template <int dim>
  void
  compare(const Scene<dim> &scene, Session &session);
} // namespace springfit

#endif
