#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/motion/critical_step.h>
#include <springfit/motion/stable_step.h>
#include <springfit/response/network_body.h>
#include <springfit/studies/comparison_files.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/network_exports.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace springfit
{
  namespace
  {
    /** A flag per node: all of its components are held. */
    std::vector<bool>
    held_nodes(const std::vector<bool> &held, const Eigen::Index dim)
    {
      std::vector<bool> nodes(held.size() / dim);
      for (std::size_t v = 0; v < nodes.size(); ++v)
        nodes[v] = std::all_of(held.begin() + dim * v,
                               held.begin() + dim * (v + 1),
                               [](const bool is_held) { return is_held; });
      return nodes;
    }

    /** Volumes, angles and couplings are stiff besides the springs, s. */
    double
    stable_step_at_rest(const SpringNetwork &network,
                        const std::vector<bool> &held)
    {
      const NetworkBody body(network);
      MovingBody moving;
      moving.elastic = &body;
      moving.mass    = Eigen::Map<const Eigen::VectorXd>(network.mass.data(),
                                                      network.mass.size());
      moving.held    = held;
      return critical_step(moving, 0. * network.nodes).step;
    }

    template <int dim>
    ExportedMotion
    motion_of(const DynamicsSettings<dim> &settings, const double stable_step)
    {
      return {settings.step > 0. ? settings.step : 0.5 * stable_step,
              settings.end - settings.begin,
              settings.damping.mass_factor,
              settings.damping.stiffness_factor,
              settings.spring_damper};
    }

    /** As a program is given it: with each kinematics, if it knows both. */
    std::vector<ExportedScene>
    in_kinematics(const ExportedScene &scene,
                  const Exporter &exporter,
                  const std::vector<Kinematics> &kinematics)
    {
      if (!exporter.knows_small_displacements)
        return {scene};
      std::vector<ExportedScene> scenes;
      for (const Kinematics of_springs : kinematics)
        {
          scenes.push_back(scene);
          scenes.back().name += suffix_of(of_springs);
          scenes.back().has_true_forces = of_springs == Kinematics::nonlinear;
        }
      return scenes;
    }

    std::string
    word_of_format(const Exporter &exporter)
    {
      return "'" + word_of(export_format_words(), exporter.format) + "'";
    }

    std::string
    refusal(const Exporter &exporter, const ExportedScene &scene)
    {
      return word_of_format(exporter) + " cannot hold the " +
             join(exporter.missing(scene)) + " of '" + scene.network + "'.";
    }

    /** The same network, free and at rest. */
    ExportedScene
    network_alone(ExportedScene scene)
    {
      for (auto &held : scene.held)
        held = {false, false, false};
      scene.forces.setZero();
      scene.support.setZero();
      scene.motion.reset();
      return scene;
    }

    /** How to mend that a format cannot hold a scene. */
    std::string
    way_out(const Exporter &exporter, const ExportedScene &scene)
    {
      const std::string holds = "It holds " + exporter.holds;
      const std::string numpy = "export to numpy, which holds everything.";
      if (exporter.missing(network_alone(scene)).empty())
        return holds +
               ". Its springs are there, what holds or moves them is not: leave "
               "it out, or " +
               numpy;
      return holds + ": set in section Fit " + exporter.best + ", or " + numpy;
    }

    /** @throws EntryError when a format can hold none of the scenes. */
    void
    check(const std::vector<Exporter> &exporters,
          const std::vector<Kinematics> &kinematics,
          const std::vector<ExportedScene> &scenes)
    {
      for (const auto &exporter : exporters)
        {
          std::string reason, mend;
          bool is_held = false;
          for (const auto &of_network : scenes)
            for (const auto &scene :
                 in_kinematics(of_network, exporter, kinematics))
              if (exporter.missing(scene).empty())
                is_held = true;
              else if (reason.empty())
                {
                  reason = refusal(exporter, scene);
                  mend   = way_out(exporter, scene);
                }
          if (!is_held)
            throw EntryError("Output/Export", reason, mend);
        }
    }

    template <int dim, int spacedim>
    std::vector<bool>
    nothing_held(const CalibratedScene<dim, spacedim> &calibrated)
    {
      return std::vector<bool>(calibrated.networks.front().network.nodes.size(),
                               false);
    }

    template <int dim, int spacedim>
    std::vector<ExportedScene>
    scenes_under_loads(const CalibratedScene<dim, spacedim> &calibrated,
                       const std::vector<bool> &held,
                       const std::vector<LoadCase> &cases)
    {
      std::vector<ExportedScene> scenes;
      for (const auto &load_case : cases)
        for (const auto &network : calibrated.networks)
          scenes.push_back(
            scene_of_network(network.network, network.name, held, load_case));
      return scenes;
    }

    template <int dim, int spacedim>
    std::vector<ExportedScene>
    scenes_without_load(const CalibratedScene<dim, spacedim> &calibrated,
                        const std::vector<bool> &held)
    {
      LoadCase none;
      none.load =
        load_of_forces(0. * calibrated.networks.front().network.nodes);
      return scenes_under_loads(calibrated, held, {none});
    }

    /** At so many times, whatever happens between them. */
    template <int dim>
    bool
    changes(const Excitation &excitation, const DynamicsSettings<dim> &settings)
    {
      constexpr int n_times = 200;
      const auto first      = excitation.load(settings.begin);
      for (int i = 1; i <= n_times; ++i)
        {
          const auto load = excitation.load(
            settings.begin + i * (settings.end - settings.begin) / n_times);
          if (load.forces != first.forces || load.support != first.support)
            return true;
        }
      return false;
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

  ExportedScene
  scene_of_network(const SpringNetwork &network,
                   const std::string &name,
                   const std::vector<bool> &held,
                   const LoadCase &load_case)
  {
    const std::string &of_case = load_case.name;
    auto scene =
      exported(network,
               "export_" + (of_case.empty() ? "" : of_case + '_') + name,
               held,
               load_case.load);
    scene.network = name;
    scene.title   = "springfit's network " + name +
                  (of_case.empty() ? "" : ", load case " + of_case);
    const double bound =
      spring_bound_of_step(network, held_nodes(held, network.nodes.rows()));
    if (std::isfinite(bound))
      scene.stable_step = bound;
    return scene;
  }

  template <int dim, int spacedim>
  void
  check_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated)
  {
    const auto wanted = exporters(scene.output);
    if (!wanted.empty())
      check(wanted,
            scene.statics.kinematics(),
            scenes_without_load(calibrated, nothing_held(calibrated)));
  }

  template <int dim, int spacedim>
  void
  check_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                const std::vector<bool> &held,
                const std::vector<LoadCase> &cases)
  {
    const auto wanted = exporters(scene.output);
    if (!wanted.empty())
      check(wanted,
            scene.statics.kinematics(),
            scenes_under_loads(calibrated, held, cases));
  }

  template <int dim, int spacedim>
  void
  check_moving_exports(const Scene<spacedim> &scene,
                       const CalibratedScene<dim, spacedim> &calibrated,
                       const std::vector<bool> &held)
  {
    const auto wanted = exporters(scene.output);
    if (wanted.empty())
      return;
    auto scenes = scenes_without_load(calibrated, held);
    for (auto &of_network : scenes)
      of_network.motion =
        motion_of(scene.dynamics.settings(), of_network.stable_step);
    check(wanted, scene.statics.kinematics(), scenes);
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
      // Once for all load cases.
      std::set<std::string> warnings;
      const auto warn = [&](const std::string &text) {
        if (warnings.insert(text).second)
          session.warn(text);
      };
      for (const auto &exporter : exporters)
        for (const auto &of_network : scenes)
          for (const auto &scene :
               in_kinematics(of_network, exporter, kinematics))
            {
              if (!exporter.missing(scene).empty())
                {
                  warn(refusal(exporter, scene) + " It is not exported there.");
                  continue;
                }
              exporter.write(session.draft(), scene);
              for (const auto &what : exporter.left_out(scene))
                warn(word_of_format(exporter) + " leaves out the " + what +
                     '.');
            }
    });
  }

  template <int dim, int spacedim>
  void
  write_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                Session &session)
  {
    const auto wanted = exporters(scene.output);
    if (wanted.empty())
      return;
    write_exports(wanted,
                  scene.statics.kinematics(),
                  scenes_without_load(calibrated, nothing_held(calibrated)),
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
    const auto wanted = exporters(scene.output);
    if (wanted.empty())
      return;
    write_exports(wanted,
                  scene.statics.kinematics(),
                  scenes_under_loads(calibrated, held, cases),
                  session);
  }

  template <int dim, int spacedim>
  void
  write_moving_exports(const Scene<spacedim> &scene,
                       const CalibratedScene<dim, spacedim> &calibrated,
                       const Loading &loading,
                       Session &session)
  {
    const auto wanted = exporters(scene.output);
    if (wanted.empty())
      return;
    const auto settings = scene.dynamics.settings();
    std::map<std::string, double> stable_steps;
    for (const auto &network : calibrated.networks)
      if (!has_springs_alone(network.network.families))
        stable_steps[network.name] =
          stable_step_at_rest(network.network, loading.held);
    std::vector<ExportedScene> scenes;
    bool has_changes = false;
    for (const auto &load_case : loading.cases)
      {
        const auto excitation =
          make_excitation(scene, calibrated, loading, load_case, settings);
        has_changes       = has_changes || changes(excitation, settings);
        LoadCase at_first = load_case;
        at_first.load     = excitation.load(settings.begin);
        for (const auto &network : calibrated.networks)
          {
            scenes.push_back(scene_of_network(
              network.network, network.name, loading.held, at_first));
            const auto found = stable_steps.find(network.name);
            if (found != stable_steps.end() && std::isfinite(found->second))
              scenes.back().stable_step = found->second;
            scenes.back().motion =
              motion_of(settings, scenes.back().stable_step);
          }
      }
    write_exports(wanted, scene.statics.kinematics(), scenes, session);
    if (has_changes)
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
  check_exports(const Scene<2> &, const CalibratedScene<2> &);
  template void
  check_exports(const Scene<2> &,
                const CalibratedScene<2> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &);
  template void
  check_moving_exports(const Scene<2> &,
                       const CalibratedScene<2> &,
                       const std::vector<bool> &);
  template void
  write_exports(const Scene<2> &, const CalibratedScene<2> &, Session &);
  template void
  write_exports(const Scene<2> &,
                const CalibratedScene<2> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &,
                Session &);
  template void
  write_moving_exports(const Scene<2> &,
                       const CalibratedScene<2> &,
                       const Loading &,
                       Session &);
  template void
  check_exports(const Scene<3> &, const CalibratedScene<2, 3> &);
  template void
  check_exports(const Scene<3> &,
                const CalibratedScene<2, 3> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &);
  template void
  check_moving_exports(const Scene<3> &,
                       const CalibratedScene<2, 3> &,
                       const std::vector<bool> &);
  template void
  write_exports(const Scene<3> &, const CalibratedScene<2, 3> &, Session &);
  template void
  write_exports(const Scene<3> &,
                const CalibratedScene<2, 3> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &,
                Session &);
  template void
  write_moving_exports(const Scene<3> &,
                       const CalibratedScene<2, 3> &,
                       const Loading &,
                       Session &);
  template void
  check_exports(const Scene<3> &, const CalibratedScene<3> &);
  template void
  check_exports(const Scene<3> &,
                const CalibratedScene<3> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &);
  template void
  check_moving_exports(const Scene<3> &,
                       const CalibratedScene<3> &,
                       const std::vector<bool> &);
  template void
  write_exports(const Scene<3> &, const CalibratedScene<3> &, Session &);
  template void
  write_exports(const Scene<3> &,
                const CalibratedScene<3> &,
                const std::vector<bool> &,
                const std::vector<LoadCase> &,
                Session &);
  template void
  write_moving_exports(const Scene<3> &,
                       const CalibratedScene<3> &,
                       const Loading &,
                       Session &);
} // namespace springfit
