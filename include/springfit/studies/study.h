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
    compare,
    sweep,
    dynamics,
    tradeoff,
    adapt,
    stability
  };

  const WordTable<StudyKind> &
  study_words();

  /**
   * Set the entries that a study chooses by itself.
   *
   * @throws EntryError
   */
  template <int dim>
  void
  complete_study(StudyKind study, Scene<dim> &scene);

  /**
   * Check the sections that only some studies use, and what must suit the
   * study.
   *
   * @throws EntryError
   */
  template <int dim>
  void
  check_study(StudyKind study, const Scene<dim> &scene);

  /** Run a study; its results are in the session's output folder afterwards. */
  template <int dim>
  void
  run_study(StudyKind study, const Scene<dim> &scene, Session &session);

  // Of cells of dimension dim, as Geometry::dimension_of_cells() says.

  /** Springs for a mesh: constants, masses and what the fits reached. */
  template <int dim, int spacedim>
  void
  calibrate(const Scene<spacedim> &scene, Session &session);

  /**
   * The springs and the finite elements under the same loads, and how far
   * apart they are.
   */
  template <int dim, int spacedim>
  void
  compare(const Scene<spacedim> &scene, Session &session);

  /**
   * The springs and the finite elements in motion under the same loads, beside
   * each other, with tables and series that grow while it runs.
   */
  template <int dim, int spacedim>
  void
  dynamics(const Scene<spacedim> &scene, Session &session);

  /**
   * Every model on every mesh that section Tradeoff asks for: how far it is
   * from a fine reference and what it costs, and which one to take.
   */
  template <int dim, int spacedim>
  void
  tradeoff(const Scene<spacedim> &scene, Session &session);

  /**
   * A model for each cell of one mesh, the cheapest with which the whole is
   * accurate enough.
   */
  template <int dim, int spacedim>
  void
  adapt(const Scene<spacedim> &scene, Session &session);

  /**
   * Every model at the extremes that section Stability names: verdicts, and
   * where they change.
   */
  template <int dim, int spacedim>
  void
  stability(const Scene<spacedim> &scene, Session &session);

  /**
   * What a single cell delivers in a tensile test, over the material's
   * constants (Figure 9 of Natsupakpong and Cavusoglu 2010).
   */
  template <int dim>
  void
  sweep(const Scene<dim> &scene, Session &session);
} // namespace springfit

#endif
