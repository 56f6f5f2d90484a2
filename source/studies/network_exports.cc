#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/motion/stable_step.h>
#include <springfit/studies/comparison_files.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/network_exports.h>

#include <cmath>

namespace springfit
{
  namespace
  {
    ExportedScene
    scene_of_network(const CalibratedNetwork &calibrated,
                     const std::string &load_case,
                     const std::vector<bool> &held,
                     const NodalLoad &load)
    {
      const std::string prefix = load_case.empty() ? "" : load_case + '_';
      auto scene =
        exported(calibrated.network, prefix + calibrated.name, held, load);
      scene.title = "springfit's network " + calibrated.name +
                    (load_case.empty() ? "" : ", load case " + load_case);
      const double bound = spring_bound_of_step(calibrated.network, held);
      if (std::isfinite(bound))
        scene.stable_step = bound;
      return scene;
    }

    ExportedScene
    at_rest(ExportedScene scene)
    {
      scene.forces.setZero();
      scene.support.setZero();
      scene.has_true_forces = true;
      scene.motion.reset();
      return scene;
    }

    std::string
    refusal(const Exporter &exporter,
            const std::vector<std::string> &missing,
            const std::string &name)
    {
      return "'" + word_of(export_format_words(), exporter.format) +
             "' cannot hold the " + join(missing) + " of '" + name + "'.";
    }
  } // namespace

  template <int dim>
  std::vector<Exporter>
  exporters(const OutputSection<dim> &output)
  {
    std::vector<Exporter> all;
    for (const ExportFormat format : output.formats())
      all.push_back(exporter_of(format, output.sofa_version()));
    return all;
  }

  void
  check_exports(const std::vector<Exporter> &exporters,
                const std::vector<ExportedScene> &scenes,
                Session &session)
  {
    for (const auto &exporter : exporters)
      {
        std::vector<std::string> refusals;
        for (const auto &scene : scenes)
          {
            const auto missing = exporter.missing(scene);
            if (!missing.empty())
              refusals.push_back(refusal(exporter, missing, scene.name));
          }
        if (!refusals.empty() && refusals.size() == scenes.size())
          throw EntryError("Output/Export",
                           refusals.front(),
                           "It holds " + exporter.holds +
                             ": set in section Fit " + exporter.best +
                             ", or export to numpy, which holds everything.");
        for (const auto &text : refusals)
          session.warn(text + " It is not exported there.");
      }
  }

  template <int dim, int spacedim>
  void
  check_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                const std::vector<bool> &held,
                Session &session)
  {
    const auto wanted = exporters(scene.output);
    if (wanted.empty())
      return;
    std::vector<ExportedScene> scenes;
    for (const auto &network : calibrated.networks)
      scenes.push_back(scene_of_network(
        network, "", held, load_of_forces(0. * network.network.nodes)));
    check_exports(wanted, scenes, session);
  }

  void
  write_exports(const std::vector<Exporter> &exporters,
                const std::vector<Kinematics> &kinematics,
                const std::vector<ExportedScene> &scenes,
                Session &session)
  {
    if (exporters.empty())
      return;
    dealii::TimerOutput::Scope scope(session.timer(), "Exports");
    run_on_root(session.communicator(), [&]() {
      const auto write = [&](const Exporter &exporter,
                             const ExportedScene &scene) {
        const auto missing = exporter.missing(scene);
        if (missing.empty())
          exporter.write(session.draft(), scene);
        else if (exporter.missing(at_rest(scene)).empty())
          // Else it has been said of the network.
          session.warn(refusal(exporter, missing, scene.name) +
                       " It is not exported there.");
      };
      for (const auto &exporter : exporters)
        for (const auto &scene : scenes)
          if (!exporter.knows_small_displacements)
            write(exporter, scene);
          else
            for (const auto of_springs : kinematics)
              {
                auto of_kinematics = scene;
                of_kinematics.name += suffix_of(of_springs);
                of_kinematics.has_true_forces =
                  of_springs == Kinematics::nonlinear;
                write(exporter, of_kinematics);
              }
    });
  }

  template <int dim, int spacedim>
  void
  write_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                Session &session)
  {
    const auto &nodes = calibrated.networks.front().network.nodes;
    LoadCase none;
    none.load = load_of_forces(0. * nodes);
    write_exports(scene,
                  calibrated,
                  std::vector<bool>(nodes.size(), false),
                  {none},
                  session);
  }

  template <int dim, int spacedim>
  void
  write_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                const std::vector<bool> &held,
                const std::vector<LoadCase> &cases,
                Session &session)
  {
    // One at a time: each has a copy of the springs.
    for (const auto &load_case : cases)
      for (const auto &network : calibrated.networks)
        write_exports(
          exporters(scene.output),
          scene.statics.kinematics(),
          {scene_of_network(network, load_case.name, held, load_case.load)},
          session);
  }

  template <int dim, int spacedim>
  void
  write_moving_exports(const Scene<spacedim> &scene,
                       const CalibratedScene<dim, spacedim> &calibrated,
                       const Loading &loading,
                       Session &session)
  {
    const auto wanted   = exporters(scene.output);
    const auto settings = scene.dynamics.settings();
    if (wanted.empty())
      return;
    bool changes = false;
    for (const auto &load_case : loading.cases)
      {
        const auto excitation =
          make_excitation(scene, calibrated, loading, load_case, settings);
        const auto load = excitation.load(settings.begin);
        const auto last = excitation.load(settings.end);
        changes |= load.forces != last.forces || load.support != last.support;
        for (const auto &network : calibrated.networks)
          {
            auto exported =
              scene_of_network(network, load_case.name, loading.held, load);
            const double step =
              settings.step > 0. ? settings.step : 0.9 * exported.stable_step;
            exported.motion = ExportedMotion{step,
                                             settings.end - settings.begin,
                                             settings.damping.mass_factor,
                                             settings.damping.stiffness_factor,
                                             settings.spring_damper};
            write_exports(wanted,
                          scene.statics.kinematics(),
                          {exported},
                          session);
          }
      }
    if (changes)
      session.warn("The loads change over time: exported scenes have those at "
                   "the beginning.");
    if (!scene.contact.obstacles().empty())
      session.warn("Obstacles are not in the exported scenes.");
    if (!settings.openings.empty())
      session.warn("Openings are not in the exported scenes.");
  }

  template std::vector<Exporter>
  exporters(const OutputSection<2> &);
  template std::vector<Exporter>
  exporters(const OutputSection<3> &);
  template void
  check_exports(const Scene<2> &,
                const CalibratedScene<2> &,
                const std::vector<bool> &,
                Session &);
  template void
  write_exports(const Scene<2> &, const CalibratedScene<2> &, Session &);
  template void
  check_exports(const Scene<3> &,
                const CalibratedScene<2, 3> &,
                const std::vector<bool> &,
                Session &);
  template void
  write_exports(const Scene<3> &, const CalibratedScene<2, 3> &, Session &);
  template void
  check_exports(const Scene<3> &,
                const CalibratedScene<3> &,
                const std::vector<bool> &,
                Session &);
  template void
  write_exports(const Scene<3> &, const CalibratedScene<3> &, Session &);
  template void
  write_exports(const Scene<2> &,
                const CalibratedScene<2> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &,
                Session &);
  template void
  write_exports(const Scene<3> &,
                const CalibratedScene<2, 3> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &,
                Session &);
  template void
  write_exports(const Scene<3> &,
                const CalibratedScene<3> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &,
                Session &);
  template void
  write_moving_exports(const Scene<2> &,
                       const CalibratedScene<2> &,
                       const Loading &,
                       Session &);
  template void
  write_moving_exports(const Scene<3> &,
                       const CalibratedScene<2, 3> &,
                       const Loading &,
                       Session &);
  template void
  write_moving_exports(const Scene<3> &,
                       const CalibratedScene<3> &,
                       const Loading &,
                       Session &);
} // namespace springfit
