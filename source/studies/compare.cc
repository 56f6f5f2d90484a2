#include <springfit/comparison/delivered_constants.h>
#include <springfit/comparison/errors.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/progress.h>
#include <springfit/output/tables.h>
#include <springfit/output/vtu.h>
#include <springfit/response/stability.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/study.h>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    /** A load case, scaled, with the response of every model to it. */
    struct CaseResult
    {
      LoadCase load_case;
      Equilibrium reference;
      std::vector<Equilibrium> models; // in the order of the networks
    };

    /** Forces such that the reference deforms as much as the user asks. */
    template <int dim>
    std::vector<CaseResult>
    solve_reference(const Scene<dim> &scene,
                    const Discretization<dim> &discretization,
                    const CalibratedScene<dim> &calibrated,
                    const Loading &loading,
                    Session &session)
    {
      dealii::TimerOutput::Scope scope(session.timer(), "Finite elements");
      const auto model = scene.statics.finite_elements(discretization,
                                                       calibrated.element,
                                                       calibrated.materials);
      std::vector<CaseResult> results;
      Progress progress("Responses of the finite elements",
                        loading.cases.size(),
                        session.is_root());
      for (const auto &unit : loading.cases)
        {
          progress.step();
          CaseResult result{unit, model.respond(unit.forces), {}};
          const double largest =
            largest_displacement(result.reference.displacement);
          if (!(largest > 0.))
            throw EntryError("Loads/Cases",
                             "the load '" + word_of(load_words(), unit.load) +
                               "' moves nothing.",
                             "Load another boundary.");
          const double scale = loading.deformation * loading.extent / largest;
          result.load_case.forces *= scale;
          result.reference.displacement *= scale;
          results.push_back(result);
        }
      return results;
    }

    template <int dim>
    void
    solve_networks(const Scene<dim> &scene,
                   const Discretization<dim> &discretization,
                   const CalibratedScene<dim> &calibrated,
                   Session &session,
                   std::vector<CaseResult> &results)
    {
      Progress progress("Responses of the springs",
                        calibrated.networks.size() * results.size(),
                        session.is_root());
      for (const auto &network : calibrated.networks)
        {
          dealii::TimerOutput::Scope scope(session.timer(),
                                           "Springs, " + network.fit);
          const auto model =
            scene.statics.springs(discretization, network.network, network.fit);
          for (auto &result : results)
            {
              result.models.push_back(model.respond(result.load_case.forces));
              progress.step();
            }
        }
    }

    /** The material's constants as a tensile test would find them. */
    template <int dim>
    std::optional<YoungPoisson>
    delivered(const Scene<dim> &scene,
              const CalibratedScene<dim> &calibrated,
              const Loading &loading,
              const Eigen::MatrixXd &forces,
              const Eigen::MatrixXd &displacement)
    {
      const auto apparent =
        delivered_constants(*calibrated.mesh,
                            calibrated.element,
                            loading.axis,
                            displacement,
                            forces,
                            calibrated.materials.begin()->second.thickness);
      if (apparent && dim == 2 &&
          scene.material.plane_state() == PlaneState::strain)
        return from_plane_strain(*apparent);
      return apparent;
    }

    /**
     * Warn of networks that are not at rest in a minimum of energy. Counting
     * takes a direct factorisation, which is too much for the largest ones.
     */
    template <int dim>
    void
    check_stability(const CalibratedScene<dim> &calibrated,
                    const Loading &loading,
                    Session &session)
    {
      constexpr Eigen::Index largest = dim == 2 ? 50000 : 5000; // nodes
      for (const auto &network : calibrated.networks)
        if (n_negative(network.network) > 0 &&
            network.network.nodes.cols() <= largest)
          if (const unsigned int n =
                n_unstable_motions(network.network, loading.fixed);
              n > 0)
            session.warn(
              "The springs of the fit '" + network.fit +
              "' are unstable: " + std::to_string(n) +
              " of their motions release energy, so that their figures below "
              "are not those of an object at rest. Set 'Nonnegative = true' "
              "in section Fit.");
    }

    template <int dim>
    std::vector<ComparisonRow>
    make_rows(const Scene<dim> &scene,
              const CalibratedScene<dim> &calibrated,
              const Loading &loading,
              const std::vector<CaseResult> &results)
    {
      const auto &mesh = *calibrated.mesh;
      const auto row = [&](const CaseResult &result, const Equilibrium &model) {
        ComparisonRow row{};
        row.load_case  = word_of(load_words(), result.load_case.load);
        row.kinematics = scene.statics.kinematics();
        row.errors =
          error_norms(result.reference.displacement, model.displacement);
        if (result.load_case.load == Load::tension)
          row.delivered = delivered(scene,
                                    calibrated,
                                    loading,
                                    result.load_case.forces,
                                    model.displacement);
        row.n_nodes     = mesh.triangulation.n_vertices();
        row.n_cells     = mesh.triangulation.n_active_cells();
        row.fem_seconds = result.reference.seconds;
        return row;
      };

      std::vector<ComparisonRow> rows;
      for (const auto &result : results)
        {
          rows.push_back(row(result, result.reference));
          rows.back().fit        = "fem";
          rows.back().enrichment = "none";
          for (std::size_t m = 0; m < result.models.size(); ++m)
            {
              const auto &network = calibrated.networks[m];
              rows.push_back(row(result, result.models[m]));
              rows.back().fit               = network.fit;
              rows.back().enrichment        = network.enrichment;
              rows.back().n_springs         = network.network.stiffness.size();
              rows.back().n_negative        = n_negative(network.network);
              rows.back().calibrate_seconds = network.seconds;
              rows.back().lem_seconds       = result.models[m].seconds;
            }
        }
      return rows;
    }

    std::string
    summary_line(const ComparisonRow &row)
    {
      char text[200];
      std::snprintf(text,
                    sizeof(text),
                    "%-12s %-12s %8.3g %8.3g",
                    row.load_case.c_str(),
                    row.fit.c_str(),
                    row.errors.e_rms_percent,
                    row.errors.e_max_percent);
      std::string line = text;
      if (row.delivered)
        {
          std::snprintf(text,
                        sizeof(text),
                        " %10.4g %8.3g",
                        row.delivered->youngs_modulus,
                        row.delivered->poissons_ratio);
          line += text;
        }
      return line;
    }

    template <int dim>
    void
    write_pictures(const std::filesystem::path &folder,
                   const CalibratedScene<dim> &calibrated,
                   const std::vector<CaseResult> &results)
    {
      const auto &networks = calibrated.networks;
      std::vector<std::pair<double, std::string>> fem_files;
      std::vector<std::vector<std::pair<double, std::string>>> files(
        networks.size());
      std::vector<std::vector<NodalField>> spring_fields(networks.size());

      for (std::size_t r = 0; r < results.size(); ++r)
        {
          const auto &result     = results[r];
          const std::string name = word_of(load_words(), result.load_case.load);
          fem_files.emplace_back(r, name + "_fem.vtu");
          write_mesh_vtu(folder / fem_files.back().second,
                         *calibrated.mesh,
                         {{"displacement", result.reference.displacement},
                          {"force", result.load_case.forces}});
          for (std::size_t m = 0; m < networks.size(); ++m)
            {
              const auto &displacement = result.models[m].displacement;
              files[m].emplace_back(r, name + '_' + networks[m].fit + ".vtu");
              write_mesh_vtu(folder / files[m].back().second,
                             *calibrated.mesh,
                             {{"displacement", displacement},
                              {"error",
                               nodal_errors(result.reference.displacement,
                                            displacement)
                                 .transpose()}});
              spring_fields[m].push_back(
                {"displacement_" + name, displacement});
            }
        }
      write_pvd(folder / "fem.pvd", fem_files);
      for (std::size_t m = 0; m < networks.size(); ++m)
        {
          write_pvd(folder / (networks[m].fit + ".pvd"), files[m]);
          write_springs_vtu<dim>(folder /
                                   ("springs_" + networks[m].fit + ".vtu"),
                                 networks[m].network,
                                 spring_fields[m]);
        }
    }
  } // namespace

  template <int dim>
  void
  compare(const Scene<dim> &scene, Session &session)
  {
    auto calibrated = make_scene(scene, session);
    const auto loading =
      scene.loads.resolve(*calibrated.mesh,
                          calibrated.element,
                          calibrated.materials.begin()->second.thickness);
    calibrate_scene(scene, calibrated, session);

    const Discretization<dim> discretization(*calibrated.mesh,
                                             loading.fixed,
                                             session.communicator());
    auto results =
      solve_reference(scene, discretization, calibrated, loading, session);
    solve_networks(scene, discretization, calibrated, session, results);
    check_stability(calibrated, loading, session);
    const auto rows = make_rows(scene, calibrated, loading, results);

    session.print(
      "\nSprings against finite elements (errors in % of the largest "
      "displacement):\n"
      "case         fit             e_rms    e_max   E_out Pa   nu_out");
    for (const auto &row : rows)
      if (row.fit != "fem" || row.delivered)
        session.print(summary_line(row));

    dealii::TimerOutput::Scope scope(session.timer(), "Output");
    run_on_root(session.communicator(), [&]() {
      write_comparison(session.output_directory(), rows);
      write_pictures(session.output_directory(), calibrated, results);
    });
    session.print("\nResults are in " + session.output_directory().string() +
                  ": comparison.csv is the table above; open " +
                  calibrated.networks.front().fit +
                  ".pvd and fem.pvd in ParaView and apply Warp By Vector.");
  }

  template void
  compare<2>(const Scene<2> &, Session &);
  template void
  compare<3>(const Scene<3> &, Session &);
} // namespace springfit
