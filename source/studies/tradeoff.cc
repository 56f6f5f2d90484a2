#include <springfit/calibration/calibration.h>
#include <springfit/comparison/interpolation.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/progress.h>
#include <springfit/output/gnuplot.h>
#include <springfit/output/tradeoff_page.h>
#include <springfit/output/tradeoff_table.h>
#include <springfit/response/stability.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/fine_reference.h>
#include <springfit/studies/measured_model.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/recommended_scene.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/study.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    /** A mesh with all models on it. It refers to itself. */
    template <int dim, int spacedim>
    struct MeasuredMesh
    {
      MeasuredMesh() = default;

      MeasuredMesh(const MeasuredMesh &) = delete;
      MeasuredMesh &
      operator=(const MeasuredMesh &) = delete;

      CalibratedScene<dim, spacedim> calibrated;
      Loading loading;
      std::unique_ptr<const Discretization<spacedim>> discretization;
      Interpolation at_points;
      std::vector<NodalLoad> loads;
      Excitation excitation;
      std::vector<MeasuredModel<spacedim>> models;
    };

    template <int dim, int spacedim>
    TradeoffRow
    row_of_mesh(const Mesh<dim, spacedim> &mesh,
                const Discretization<spacedim> &discretization,
                const Meshing &meshing)
    {
      TradeoffRow row;
      row.cells     = word_of(cell_kind_words(), mesh.cell_kind);
      row.cell_size = size_of_cells(mesh, meshing);
      for (const double size : meshing.cell_size)
        row.cell_size_entry += (row.cell_size_entry.empty() ? "" : ", ") +
                               dealii::Patterns::Tools::to_string(size);
      row.n_refinements = meshing.refinements;
      row.n_dofs        = std::count(discretization.held().begin(),
                              discretization.held().end(),
                              false);
      return row;
    }

    template <int dim, int spacedim>
    void
    add_finite_elements(const Scene<spacedim> &scene,
                        const MaterialLaw law,
                        const TradeoffRow &of_mesh,
                        MeasuredMesh<dim, spacedim> &measured)
    {
      const Meter meter;
      auto model =
        finite_elements_in_motion(law,
                                  measured.calibrated,
                                  measured.excitation.nodes,
                                  everything(*measured.calibrated.mesh));
      TradeoffRow row = of_mesh;
      row.model       = "fem";
      row.fit         = word_of(material_law_words(), law);
      row.enrichment  = "none";
      row.kinematics  = model->kinematics;
      row.setup       = meter.seconds();
      row.memory      = meter.mebibytes();
      measured.models.emplace_back(row, std::move(model), [&, law]() {
        return scene.statics.finite_elements_of(law,
                                                *measured.discretization,
                                                *measured.calibrated.mesh,
                                                measured.calibrated.element,
                                                measured.calibrated.materials);
      });
    }

    template <int dim, int spacedim>
    void
    add_network(const Scene<spacedim> &scene,
                const CalibratedNetwork &network,
                const Kinematics kinematics,
                const double spring_damper,
                const TradeoffRow &of_mesh,
                MeasuredMesh<dim, spacedim> &measured)
    {
      TradeoffRow row = of_mesh;
      row.model       = "springs";
      row.fit         = network.fit;
      row.enrichment  = network.enrichment;
      row.kinematics  = word_of(kinematics_words(), kinematics);
      row.n_springs   = n_springs(network.network.families);
      row.calibrate   = network.seconds;
      if (const unsigned int n =
            n_unstable_at_rest(network.network, measured.loading.held)
              .value_or(0);
          n > 0)
        row.failure = "it is unstable at rest, " + std::to_string(n) +
                      " of its motions release energy.";
      const Meter meter;
      auto model =
        network_in_motion(network, network.network, kinematics, spring_damper);
      row.setup  = meter.seconds();
      row.memory = meter.mebibytes();
      measured.models.emplace_back(row, std::move(model), [&, kinematics]() {
        return scene.statics.springs(*measured.discretization,
                                     *measured.calibrated.mesh,
                                     measured.calibrated.element,
                                     network.network,
                                     network.name,
                                     kinematics);
      });
    }

    template <int dim, int spacedim>
    std::unique_ptr<MeasuredMesh<dim, spacedim>>
    make_models(const Scene<spacedim> &scene,
                const Meshing &meshing,
                const FineReference<spacedim> &reference,
                const DynamicsSettings<spacedim> &settings,
                Session &session)
    {
      auto measured    = std::make_unique<MeasuredMesh<dim, spacedim>>();
      auto &calibrated = measured->calibrated;
      calibrated =
        scene_of<dim>(scene.geometry.template create<dim>(
                        meshing, session.communicator(), scene.folder),
                      scene);
      const auto &mesh    = *calibrated.mesh;
      calibrated.networks = calibrate(scene.fit,
                                      mesh,
                                      calibrated.element,
                                      calibrated.materials,
                                      {},
                                      scene.statics.material_law(),
                                      session);

      auto &loading = measured->loading;
      loading =
        scene.loads.resolve(mesh, calibrated.element, calibrated.materials);
      for (std::size_t i = 0; i < loading.cases.size(); ++i)
        {
          auto &load = loading.cases[i].load;
          load       = scaled(load, reference.scales[i]);
          measured->loads.push_back(load);
        }
      measured->discretization =
        std::make_unique<const Discretization<spacedim>>(
          mesh, loading.held, session.communicator());
      measured->at_points =
        interpolation(mesh, calibrated.element, reference.points);
      measured->excitation = make_excitation(
        scene, calibrated, loading, loading.cases.front(), settings);
      // What is timed is a motion under the whole load.
      measured->excitation.load = [load = measured->loads.front()](double) {
        return load;
      };

      const auto of_mesh =
        row_of_mesh(mesh, *measured->discretization, meshing);
      const auto laws =
        scene.tradeoff.material_laws(scene.statics.material_law());
      const auto all_kinematics = scene.statics.kinematics();
      for (const auto law : laws)
        add_finite_elements(scene, law, of_mesh, *measured);
      for (const auto &network : calibrated.networks)
        for (const auto kinematics : all_kinematics)
          add_network(scene,
                      network,
                      kinematics,
                      settings.spring_damper,
                      of_mesh,
                      *measured);
      return measured;
    }

    /** The errors of a model, the worst of all load cases. */
    template <int dim, int spacedim>
    void
    measure_errors(const Scene<spacedim> &scene,
                   const FineReference<spacedim> &reference,
                   const MeasuredMesh<dim, spacedim> &measured,
                   MeasuredModel<spacedim> &model)
    {
      if (!model.row.failure.empty())
        return;
      const auto found = model.respond(measured.loads);
      if (!model.row.failure.empty())
        return;
      const auto keep = [](std::optional<double> &worst,
                           const std::optional<double> &error) {
        if (error)
          worst = std::max(worst.value_or(0.), *error);
      };
      const auto statement = scene.tradeoff.quantity();
      for (std::size_t i = 0; i < found.size(); ++i)
        {
          CommonState state;
          state.displacement =
            found[i].displacement * measured.at_points.weights;
          state.energy = model.energy(found[i].displacement);
          state.reactions =
            forces_of_supports(measured.loading, found[i].reactions);
          if (statement)
            state.quantity = value_of(on_mesh(*statement,
                                              *measured.calibrated.mesh,
                                              measured.calibrated.element,
                                              measured.loading,
                                              "Tradeoff/Quantity"),
                                      found[i]);
          const auto errors = common_errors(reference.states[i],
                                            state,
                                            reference.weights,
                                            reference.largest_quantity);
          if (!std::isfinite(errors.e_rms))
            {
              model.row.failure = "its displacements are not finite.";
              return;
            }
          keep(model.row.e_rms, errors.e_rms);
          keep(model.row.e_max, errors.e_max);
          keep(model.row.force_error, errors.force);
          keep(model.row.energy_error, errors.energy);
          keep(model.row.quantity_error, errors.quantity);
        }
    }

    /** Steps are timed under the first load case, without openings. */
    template <int spacedim>
    DynamicsSettings<spacedim>
    settings_of_steps(const Scene<spacedim> &scene)
    {
      auto settings                = scene.dynamics.settings();
      settings.integrator          = Integrator::implicit_euler;
      settings.newton.n_iterations = 1;
      settings.mass                = MassKind::lumped;
      settings.openings.clear();
      return settings;
    }

    template <int spacedim>
    ReferenceFacts
    facts_of(const FineReference<spacedim> &reference,
             const Scene<spacedim> &scene)
    {
      ReferenceFacts facts;
      facts.material_law =
        word_of(material_law_words(), scene.statics.material_law());
      facts.degree     = scene.tradeoff.reference_degree();
      facts.cells      = reference.cells;
      facts.cell_size  = reference.cell_size;
      facts.n_nodes    = reference.n_nodes;
      facts.own_error  = reference.own_error;
      facts.load_cases = reference.load_cases;
      if (const auto quantity = scene.tradeoff.quantity())
        facts.quantity = quantity->text;
      return facts;
    }

    void
    check_ranks(Session &session)
    {
      if (dealii::Utilities::MPI::n_mpi_processes(session.communicator()) > 1)
        throw EntryError("Study",
                         "times are measured on one rank.",
                         "Start springfit without mpirun.");
    }
  } // namespace

  template <int dim, int spacedim>
  void
  tradeoff(const Scene<spacedim> &scene, Session &session)
  {
    if (!scene.output.formats().empty())
      session.skip("Exports", "recommended.prm writes them when it is run");
    check_ranks(session);
    const auto settings  = settings_of_steps(scene);
    const auto demand    = scene.tradeoff.demand(settings.step);
    const auto reference = find_fine_reference<dim>(scene, session);
    const auto facts     = facts_of(reference, scene);
    session.print(describe(facts));

    std::vector<std::unique_ptr<MeasuredMesh<dim, spacedim>>> meshes;
    for (const auto &meshing : scene.tradeoff.meshings(scene.geometry))
      {
        dealii::TimerOutput::Scope scope(session.timer(), "Models");
        meshes.push_back(
          make_models<dim>(scene, meshing, reference, settings, session));
        for (auto &model : meshes.back()->models)
          measure_errors(scene, reference, *meshes.back(), model);
      }
    {
      dealii::TimerOutput::Scope scope(session.timer(), "Times");
      for (auto &mesh : meshes)
        for (auto &model : mesh->models)
          if (model.row.failure.empty())
            model.set_in_motion(settings, mesh->excitation);
      // In turn, so that a slow phase of the machine hits all.
      Progress progress("Times",
                        scene.tradeoff.n_repetitions(),
                        session.is_root());
      for (unsigned int i = 0; i < scene.tradeoff.n_repetitions(); ++i)
        {
          for (auto &mesh : meshes)
            for (auto &model : mesh->models)
              model.measure_again();
          progress.step();
        }
    }

    std::vector<TradeoffRow> rows;
    for (auto &mesh : meshes)
      for (auto &model : mesh->models)
        {
          model.finish();
          if (!model.row.failure.empty())
            session.warn(name_of(model.row) + ": " + model.row.failure);
          rows.push_back(model.row);
        }
    mark_front(demand.purpose, demand.time_step, rows);
    const Advice advice = advise(rows, demand);
    session.print(tradeoff_lines(rows, demand));
    session.print(sentence(rows, demand, advice, reference.own_error));

    dealii::TimerOutput::Scope scope(session.timer(), "Output");
    write_tradeoff(session.draft(), rows);
    if (advice.chosen)
      write_recommended_scene(session.draft(), rows[*advice.chosen], demand);
    write_page(session.draft(), rows, demand, advice, facts);
    if (advice.most_accurate)
      if (const std::string problem =
            draw(session.draft(), "tradeoff.gp", "tradeoff.md");
          !problem.empty())
        session.warn(problem);
    session.say_at_the_end(
      std::string("tradeoff.md shows all of it") +
      (advice.chosen ? "; recommended.prm is the scene to run." : "."));
  }

  template void
  tradeoff<2, 2>(const Scene<2> &, Session &);
  template void
  tradeoff<2, 3>(const Scene<3> &, Session &);
  template void
  tradeoff<3, 3>(const Scene<3> &, Session &);
} // namespace springfit
