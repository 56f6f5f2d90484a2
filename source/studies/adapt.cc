#include <springfit/comparison/errors.h>
#include <springfit/comparison/rungs.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/output/adapt_table.h>
#include <springfit/output/mesh_vtu.h>
#include <springfit/output/network_vtu.h>
#include <springfit/output/tables.h>
#include <springfit/studies/adaptation.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/measured_model.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/network_exports.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/study.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    // What a richer model does to the displacements is not foreseen.
    constexpr double safety = 0.7;

    /** What steps of a body cost. */
    template <int dim, int spacedim>
    TradeoffRow
    costs(const Scene<spacedim> &scene,
          const CalibratedScene<dim, spacedim> &calibrated,
          const Loading &loading,
          std::unique_ptr<const BodyOfMembers> body)
    {
      auto settings                = scene.dynamics.settings();
      settings.integrator          = Integrator::implicit_euler;
      settings.newton.n_iterations = 1;
      settings.openings.clear();
      auto excitation = make_excitation(
        scene, calibrated, loading, loading.cases.front(), settings);
      const auto &network = calibrated.networks.front().network;
      MeasuredModel<spacedim> model(
        {},
        body_in_motion(std::move(body),
                       scene.statics.material_law() == MaterialLaw::linear
                         ? Kinematics::linear
                         : Kinematics::nonlinear,
                       network),
        {});
      model.set_in_motion(settings, excitation);
      for (unsigned int i = 0; i < 5; ++i)
        model.measure_again();
      model.finish();
      return model.row;
    }

    template <int dim, int spacedim>
    void
    write_adapted_network(const std::filesystem::path &folder,
                          const CalibratedScene<dim, spacedim> &calibrated,
                          const SpringNetwork &network)
    {
      write_network(folder, "adapted", network);
      write_network_vtu(folder, "adapted", network, {});
      auto networks = named(calibrated.networks);
      networks.push_back({"adapted", &network});
      write_families(folder, networks);
    }

    /** For ParaView: where the accuracy was bought, and what is missing. */
    template <int dim, int spacedim>
    void
    write_judged_cases(const std::filesystem::path &folder,
                       const CalibratedScene<dim, spacedim> &calibrated,
                       const Loading &loading,
                       const std::vector<unsigned int> &models,
                       const std::vector<JudgedCase> &judged)
    {
      Eigen::VectorXd of_cells(models.size());
      for (std::size_t c = 0; c < models.size(); ++c)
        of_cells[c] = models[c];
      for (std::size_t i = 0; i < judged.size(); ++i)
        {
          Eigen::VectorXd contributions(models.size());
          for (std::size_t c = 0; c < models.size(); ++c)
            contributions[c] = std::abs(judged[i].contributions(c, models[c]));
          write_mesh_vtu(folder / (loading.cases[i].name + "_adapted.vtu"),
                         *calibrated.mesh,
                         {{"displacement", judged[i].found.displacement}},
                         {{"model", of_cells},
                          {"error_percent", contributions}});
        }
    }
  } // namespace

  template <int dim, int spacedim>
  void
  adapt(const Scene<spacedim> &scene, Session &session)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(session.communicator()) > 1)
      throw EntryError("Study",
                       "models of cells are chosen on one rank.",
                       "Start springfit without mpirun.");
    const auto settings = scene.adapt.settings();
    auto calibrated     = make_scene<dim, spacedim>(scene, session);
    auto loading        = scene.loads.resolve(*calibrated.mesh,
                                       calibrated.element,
                                       calibrated.materials);
    scene.loads.check_supports(*calibrated.mesh, loading);
    scale_canned_cases(scene, calibrated, session, loading);
    calibrate_scene(scene, calibrated, loading.held, {}, session);

    const Adaptation<dim, spacedim> adaptation(
      scene, calibrated, loading, settings, session.communicator());
    std::vector<std::string> names;
    for (unsigned int k = 0; k < adaptation.n_models(); ++k)
      names.push_back(adaptation.mixed().name(k));
    std::vector<Equilibrium> exact;
    if (settings.knows_true_error)
      exact = adaptation.respond(adaptation.mixed().exact_body());

    const unsigned int n_cells =
      calibrated.mesh->triangulation.n_active_cells();
    std::vector<unsigned int> models(n_cells, 0);
    const auto cost_of_richest =
      costs(scene,
            calibrated,
            loading,
            adaptation.mixed().body(
              std::vector<unsigned int>(n_cells, adaptation.n_models() - 1)));
    const StepTimes of_richest{cost_of_richest.explicit_step,
                               cost_of_richest.implicit_step};
    std::vector<AdaptRow> rows;
    std::vector<JudgedCase> judged;
    for (unsigned int cycle = 0;; ++cycle)
      {
        dealii::TimerOutput::Scope scope(session.timer(), "Cycles");
        const auto found = adaptation.respond(adaptation.mixed().body(models));
        const double largest =
          adaptation.largest_quantity(exact.empty() ? found : exact);
        judged.clear();
        AdaptRow row{};
        for (std::size_t i = 0; i < found.size(); ++i)
          {
            judged.push_back(adaptation.judge(found[i], models, largest));
            if (std::abs(judged.back().estimate) >= row.estimate)
              {
                row.estimate = std::abs(judged.back().estimate);
                if (settings.knows_true_error)
                  row.error =
                    std::abs(adaptation.error(exact[i], found[i], largest));
              }
          }
        for (unsigned int k = 0; k < adaptation.n_models(); ++k)
          row.n_cells.push_back(std::count(models.begin(), models.end(), k));
        const auto cost =
          costs(scene, calibrated, loading, adaptation.mixed().body(models));
        row.steps = {cost.explicit_step, cost.implicit_step};
        rows.push_back(row);
        if (row.estimate <= settings.accuracy || cycle == settings.n_cycles)
          break;
        std::vector<Eigen::MatrixXd> contributions;
        for (const auto &of_case : judged)
          contributions.push_back(of_case.contributions);
        const auto next =
          choose_rungs(contributions, models, safety * settings.accuracy);
        if (next == models)
          break;
        models = next;
      }
    session.print(adapt_lines(rows, of_richest, names));
    if (rows.back().estimate > settings.accuracy)
      session.warn("The wanted accuracy is not reached: the last of the fits "
                   "is not exact, or 'Cycles' are too few. With 'Finite "
                   "elements = true' in section Adapt there is an exact "
                   "model.");

    dealii::TimerOutput::Scope scope(session.timer(), "Output");
    run_on_root(session.communicator(), [&]() {
      const auto &folder = session.draft();
      write_adaptation(folder, rows, of_richest, names);
      write_adapted_network(folder,
                            calibrated,
                            adaptation.mixed().network(models));
      write_models_of_cells(folder, models, names);
      write_judged_cases(folder, calibrated, loading, models, judged);
    });
    if (settings.has_finite_elements && rows.back().n_cells.back() > 0)
      session.skip("Exports",
                   std::to_string(rows.back().n_cells.back()) +
                     " cells are finite elements, which no program takes for "
                     "springs; 'Finite elements = false' in section Adapt");
    else if (const auto wanted = exporters(scene.output); !wanted.empty())
      {
        const auto network = adaptation.mixed().network(models);
        std::vector<ExportedScene> scenes;
        for (const auto &load_case : loading.cases)
          scenes.push_back(
            scene_of_network(network, "adapted", loading.held, load_case));
        write_exports(wanted, {adaptation.kinematics()}, scenes, session);
      }
    session.say_at_the_end("adapt.csv is the table above; colour *_adapted.vtu "
                           "by model in ParaView.");
  }

  template void
  adapt<2, 2>(const Scene<2> &, Session &);
  template void
  adapt<2, 3>(const Scene<3> &, Session &);
  template void
  adapt<3, 3>(const Scene<3> &, Session &);
} // namespace springfit
