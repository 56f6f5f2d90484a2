#include <springfit/core/error.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/study.h>

namespace springfit
{
  const WordTable<StudyKind> &
  study_words()
  {
    static const WordTable<StudyKind> table = {
      {StudyKind::calibrate, "calibrate"},
      {StudyKind::compare, "compare"},
      {StudyKind::sweep, "sweep"},
      {StudyKind::dynamics, "dynamics"},
      {StudyKind::tradeoff, "tradeoff"},
      {StudyKind::adapt, "adapt"},
      {StudyKind::stability, "stability"}};
    return table;
  }

  namespace
  {
    /** What can be known of a motion before it begins. */
    template <int dim>
    void
    check_motion(const Scene<dim> &scene)
    {
      const auto settings = scene.dynamics.settings();
      for (const auto &obstacle : scene.contact.obstacles())
        for (const double time : {settings.begin, settings.end})
          obstacle.at(time);
      const auto factor = load_factor<dim>(settings);
      for (const double time : {settings.begin, settings.end})
        factor.value({}, time);
    }

    /** For studies that measure what steps cost. */
    template <int dim>
    void
    check_step(const Scene<dim> &scene)
    {
      if (!(scene.dynamics.settings().step > 0.))
        throw EntryError(
          "Dynamics/Time step",
          "it is 0, the largest stable one, which depends on the "
          "model.",
          "Give the step in s whose time is to be measured.");
    }
  } // namespace

  template <int dim>
  void
  complete_study(const StudyKind study, Scene<dim> &scene)
  {
    if (study == StudyKind::tradeoff)
      scene.tradeoff.choose_models();
  }

  namespace
  {
    template <int dim>
    void
    check_output(const StudyKind study, const Scene<dim> &scene)
    {
      scene.output.sofa_version();
      if (!scene.output.formats().empty() &&
          (study == StudyKind::sweep || study == StudyKind::stability))
        throw EntryError(
          "Output/Export",
          "a study of many networks keeps none of them.",
          "Set 'Study' to calibrate, compare, adapt or dynamics, or "
          "leave it empty.");
    }
  } // namespace

  template <int dim>
  void
  check_study(const StudyKind study, const Scene<dim> &scene)
  {
    check_output(study, scene);
    switch (study)
      {
        case StudyKind::calibrate:
          if (scene.fit.needs_responses())
            throw EntryError("Fit/Fields",
                             "'responses' are those to the scene's loads, but "
                             "this study loads nothing.",
                             "Set 'Study = compare', or leave them out.");
          scene.fit.check_states(scene.statics.material_law());
          break;
        case StudyKind::compare:
          scene.loads.check();
          scene.statics.check();
          scene.reference.degree();
          scene.fit.check_states(scene.statics.material_law());
          break;
        case StudyKind::sweep:
          if (scene.geometry.dimension_of_cells() < dim)
            throw EntryError("Geometry/Cells",
                             "a sweep tests a single cell, which is the same "
                             "in the plane as on a surface in space.",
                             "Set Dimension = 2.");
          if (scene.fit.scope() == Scope::object)
            throw EntryError("Fit/Scope",
                             "a sweep fits a single cell.",
                             "Set it to cell, or 'Study' to calibrate or "
                             "compare.");
          if (scene.fit.has_states())
            throw EntryError("Fit/States",
                             "a sweep tests a cell at rest.",
                             "Leave it empty, or set 'Study' to calibrate or "
                             "compare.");
          scene.sweep_range.check(scene.material);
          break;
        case StudyKind::dynamics:
          if (scene.fit.needs_responses())
            throw EntryError("Fit/Fields",
                             "'responses' are those of statics.",
                             "Set 'Study = compare', or leave them out.");
          scene.loads.check();
          scene.statics.check();
          scene.fit.check_states(scene.statics.material_law());
          check_motion(scene);
          break;
        case StudyKind::tradeoff:
          if (scene.fit.needs_responses())
            throw EntryError("Fit/Fields",
                             "'responses' are those of one mesh.",
                             "Set 'Study = compare', or leave them out.");
          scene.loads.check();
          scene.statics.check();
          scene.fit.check_states(scene.statics.material_law());
          check_motion(scene);
          check_step(scene);
          scene.tradeoff.check(scene.geometry);
          break;
        case StudyKind::adapt:
          if (scene.fit.scope() == Scope::object || scene.fit.has_states())
            throw EntryError("Fit/Scope",
                             "the models are of single cells at rest.",
                             "Set it to cell, and leave 'States' empty.");
          scene.loads.check();
          scene.statics.check();
          check_step(scene);
          scene.adapt.settings();
          break;
        case StudyKind::stability:
          if (scene.fit.scope() == Scope::object)
            throw EntryError("Fit/Scope",
                             "a study of stability fits cells.",
                             "Set it to cell.");
          if (scene.fit.has_states() &&
              scene.geometry.dimension_of_cells() < dim)
            throw EntryError("Fit/States",
                             "a surface in space is fitted at rest, where its "
                             "cells have directions of their own.",
                             "Leave it empty.");
          scene.loads.check();
          scene.statics.check();
          scene.fit.check_states(scene.statics.material_law());
          check_motion(scene);
          check_step(scene);
          scene.stability.check(
            scene.material,
            (scene.fit.rows().size() + 1) * scene.statics.kinematics().size() *
              scene.stability.settings().integrators.size());
          break;
      }
  }

  namespace
  {
    template <int dim, int spacedim>
    void
    run_study_of_cells(const StudyKind study,
                       const Scene<spacedim> &scene,
                       Session &session)
    {
      switch (study)
        {
          case StudyKind::calibrate:
            return calibrate<dim, spacedim>(scene, session);
          case StudyKind::compare:
            return compare<dim, spacedim>(scene, session);
          case StudyKind::sweep:
            return sweep(scene, session);
          case StudyKind::dynamics:
            return dynamics<dim, spacedim>(scene, session);
          case StudyKind::tradeoff:
            return tradeoff<dim, spacedim>(scene, session);
          case StudyKind::adapt:
            return adapt<dim, spacedim>(scene, session);
          case StudyKind::stability:
            return stability<dim, spacedim>(scene, session);
        }
    }
  } // namespace

  template <int spacedim>
  void
  run_study(const StudyKind study,
            const Scene<spacedim> &scene,
            Session &session)
  {
    if (scene.geometry.dimension_of_cells() == 2)
      run_study_of_cells<2>(study, scene, session);
    else if constexpr (spacedim == 3)
      run_study_of_cells<3>(study, scene, session);
  }

  template void
  complete_study<2>(StudyKind, Scene<2> &);
  template void
  complete_study<3>(StudyKind, Scene<3> &);
  template void
  check_study<2>(StudyKind, const Scene<2> &);
  template void
  check_study<3>(StudyKind, const Scene<3> &);
  template void
  run_study<2>(StudyKind, const Scene<2> &, Session &);
  template void
  run_study<3>(StudyKind, const Scene<3> &, Session &);
} // namespace springfit
