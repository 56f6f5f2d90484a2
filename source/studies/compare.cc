#include <springfit/comparison/errors.h>
#include <springfit/core/collective.h>
#include <springfit/core/incomplete_error.h>
#include <springfit/fit/methods.h>
#include <springfit/output/tables.h>
#include <springfit/reference/material_law.h>
#include <springfit/response/stability.h>
#include <springfit/response/statics.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/comparison_files.h>
#include <springfit/studies/delivered.h>
#include <springfit/studies/locking.h>
#include <springfit/studies/network_exports.h>
#include <springfit/studies/quadratic_response.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/study.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    std::string
    describe(const Loading &loading)
    {
      std::ostringstream text;
      text.precision(3);
      if (const auto &pull = loading.pull)
        {
          text << "Loads: the pull is along (";
          for (Eigen::Index d = 0; d < pull->axis.size(); ++d)
            text << (d > 0 ? ", " : "")
                 << (std::abs(pull->axis[d]) < 1e-6 ? 0. : pull->axis[d]);
          text << "), where the object measures " << pull->extent << " m.\n";
        }
      for (const auto &load_case : loading.cases)
        if (!load_case.canned)
          text << "Load case " << load_case.name << ": forces of ("
               << load_case.load.forces.rowwise().sum().transpose().format(
                    Eigen::IOFormat(3, 0, ", ", ", "))
               << ") N in all, supports moved by up to "
               << load_case.load.support.colwise().norm().maxCoeff() << " m.\n";
      return text.str();
    }

    /** Say it where no pair of models has the same kinematics. */
    template <int spacedim>
    void
    warn_of_kinematics(const Statics<spacedim> &statics, Session &session)
    {
      const auto of_springs = statics.kinematics();
      const auto have       = [&](const Kinematics kinematics) {
        return std::find(of_springs.begin(), of_springs.end(), kinematics) !=
               of_springs.end();
      };
      const bool is_linear = statics.material_law() == MaterialLaw::linear;
      if (is_linear && !have(Kinematics::linear))
        session.warn("Nonlinear springs are compared with linear finite "
                     "elements. Set 'Material law' in section Response to "
                     "compare with nonlinear ones.");
      if (!is_linear && !have(Kinematics::nonlinear))
        session.warn("Linear springs are compared with nonlinear finite "
                     "elements. Set 'Kinematics = nonlinear' in section "
                     "Response to compare nonlinear ones.");
    }

    /** Warn of networks that are not at rest in a minimum of energy. */
    template <int dim, int spacedim>
    void
    check_stability(const CalibratedScene<dim, spacedim> &calibrated,
                    const Loading &loading,
                    Session &session)
    {
      dealii::TimerOutput::Scope scope(session.timer(), "Stability");
      for (const auto &network : calibrated.networks)
        {
          const auto n = n_unstable_at_rest(network.network, loading.held);
          if (!n)
            session.skip("Stability at rest of the fit '" + network.name + "'",
                         "its unstable motions are counted by factors, which "
                         "are too large of so many nodes");
          else if (*n > 0)
            session.warn(
              "The springs of the fit '" + network.name +
              "' are unstable: " + std::to_string(*n) +
              " of their motions release energy, so that their figures below "
              "are not those of an object at rest. Set 'Nonnegative = true' "
              "in section Fit.");
        }
    }

    bool
    is_training(const Loading &loading, const LoadCase &load_case)
    {
      return std::find(loading.training.begin(),
                       loading.training.end(),
                       load_case.name) != loading.training.end();
    }

    template <int dim, int spacedim>
    std::vector<ComparisonRow>
    make_rows(const Scene<spacedim> &scene,
              const CalibratedScene<dim, spacedim> &calibrated,
              const Loading &loading,
              const std::vector<CaseResult> &results,
              const std::vector<Equilibrium> &judges)
    {
      const auto &mesh = *calibrated.mesh;
      const auto row   = [&](const CaseResult &result,
                           const Equilibrium &judge,
                           const Equilibrium &model,
                           const Kinematics kinematics) {
        ComparisonRow row{};
        row.load_case  = result.load_case.name;
        row.kinematics = word_of(kinematics_words(), kinematics);
        row.errors     = error_norms(judge.displacement, model.displacement);
        if (!result.load_case.load.forces.isZero(0.))
          row.errors_where_loaded =
            error_norms_where_loaded(judge.displacement,
                                     model.displacement,
                                     result.load_case.load.forces);
        if (result.load_case.canned == Load::tension)
          row.delivered = delivered(scene,
                                    calibrated,
                                    loading,
                                    result.load_case.load.forces,
                                    model.displacement);
        row.reactions   = forces_of_supports(loading, model.reactions);
        row.n_nodes     = mesh.triangulation.n_vertices();
        row.n_cells     = mesh.triangulation.n_active_cells();
        row.fem_seconds = result.reference.seconds;
        return row;
      };
      const Kinematics of_reference =
        scene.statics.material_law() == MaterialLaw::linear
          ? Kinematics::linear
          : Kinematics::nonlinear;

      std::vector<ComparisonRow> rows;
      for (std::size_t r = 0; r < results.size(); ++r)
        {
          const auto &result = results[r];
          if (!is_complete(result.reference))
            continue;
          const bool is_judged = r < judges.size();
          if (is_judged && !is_complete(judges[r]))
            continue;
          const auto &judge = is_judged ? judges[r] : result.reference;
          if (is_judged)
            {
              rows.push_back(row(result, judge, judge, of_reference));
              rows.back().fit        = "fem_quadratic";
              rows.back().enrichment = "none";
              rows.back().reactions.clear();
              rows.back().fem_seconds = judge.seconds;
            }
          rows.push_back(row(result, judge, result.reference, of_reference));
          rows.back().fit        = "fem";
          rows.back().enrichment = "none";
          for (const auto &response : result.networks)
            {
              if (!is_complete(response.equilibrium))
                continue;
              const auto &network = calibrated.networks[response.network];
              rows.push_back(
                row(result, judge, response.equilibrium, response.kinematics));
              rows.back().fit        = network.fit;
              rows.back().enrichment = network.enrichment;
              rows.back().is_trained =
                network.is_trained && is_training(loading, result.load_case);
              rows.back().n_springs  = n_springs(network.network.families);
              rows.back().n_negative = n_negative(network.network.families);
              rows.back().calibrate_seconds = network.seconds;
              rows.back().lem_seconds       = response.equilibrium.seconds;
            }
        }
      return rows;
    }

    bool
    is_reference(const ComparisonRow &row)
    {
      return row.fit == "fem" || row.fit == "fem_quadratic";
    }

    std::string
    summary_line(const ComparisonRow &row)
    {
      char text[200];
      std::snprintf(text,
                    sizeof(text),
                    "%-12s %-32s %-10s %8.3g %8.3g",
                    row.load_case.c_str(),
                    name_of(row.fit, row.enrichment).c_str(),
                    row.kinematics.c_str(),
                    row.errors.e_rms_percent,
                    row.errors.e_max_percent);
      std::string line = text;
      if (const auto &loaded = row.errors_where_loaded)
        {
          std::snprintf(text,
                        sizeof(text),
                        " %8.3g %8.3g",
                        loaded->e_rms_percent,
                        loaded->e_max_percent);
          line += text;
        }
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

    /** One column per load case that fits are made with, m. */
    Eigen::MatrixXd
    training_displacements(const Loading &loading,
                           const std::vector<CaseResult> &results)
    {
      Eigen::MatrixXd fields(results.front().linear_displacement.size(),
                             loading.training.size());
      Eigen::Index column = 0;
      for (const auto &result : results)
        if (is_training(loading, result.load_case))
          fields.col(column++) = result.linear_displacement.reshaped();
      return fields;
    }

    /** @throws IncompleteError when a model did not reach the whole load. */
    void
    check_completeness(const std::vector<CaseResult> &results,
                       const std::vector<Equilibrium> &judges,
                       const std::filesystem::path &folder)
    {
      std::vector<std::string> failures;
      const auto collect = [&](const CaseResult &result,
                               const Equilibrium &equilibrium) {
        if (!is_complete(equilibrium))
          failures.push_back("Load case " + result.load_case.name + ": " +
                             equilibrium.failure);
      };
      for (const auto &result : results)
        {
          collect(result, result.reference);
          for (const auto &response : result.networks)
            collect(result, response.equilibrium);
        }
      for (std::size_t r = 0; r < judges.size(); ++r)
        collect(results[r], judges[r]);
      if (!failures.empty())
        throw IncompleteError(failures.front() +
                              (failures.size() > 1
                                 ? " (And " +
                                     std::to_string(failures.size() - 1) +
                                     " more such failures, see the warnings.)"
                                 : "") +
                              " What was found is in " + folder.string() +
                              ", the last states as *_incomplete.vtu.");
    }
  } // namespace

  template <int dim, int spacedim>
  void
  compare(const Scene<spacedim> &scene, Session &session)
  {
    auto calibrated    = make_scene<dim, spacedim>(scene, session);
    const auto loading = scene.loads.resolve(*calibrated.mesh,
                                             calibrated.element,
                                             calibrated.materials);
    scene.loads.check_supports(*calibrated.mesh, loading);
    session.print(describe(loading));
    warn_of_kinematics(scene.statics, session);
    warn_of_locking(scene, calibrated, session);
    auto results = find_references(scene, calibrated, loading, session);
    calibrate_scene(scene,
                    calibrated,
                    loading.held,
                    training_displacements(loading, results),
                    session);
    check_exports(scene, calibrated, loading.held, loading.cases);
    find_responses(scene, calibrated, loading, results, session);
    check_stability(calibrated, loading, session);
    std::vector<Equilibrium> judges;
    if (scene.reference.degree() == 2)
      judges = quadratic_responses<dim>(scene, loading, results, session);
    else
      session.skip("Quadratic elements",
                   "'Reference = linear elements' in section Response");
    const auto rows = make_rows(scene, calibrated, loading, results, judges);

    session.print(
      "\nSprings against " + std::string(judges.empty() ? "" : "quadratic ") +
      "finite elements (" +
      word_of(material_law_words(), scene.statics.material_law()) +
      "; errors in % of the largest displacement, of all nodes and of the loaded "
      "ones):\n"
      "case         fit                              kinematics    e_rms    e_max   "
      "loaded:      max   E_out Pa   nu_out");
    for (const auto &row : rows)
      if (!is_reference(row) || row.delivered || row.errors.e_max_percent > 0.)
        session.print(summary_line(row));

    {
      dealii::TimerOutput::Scope scope(session.timer(), "Output");
      run_on_root(session.communicator(), [&]() {
        write_comparison(session.draft(), rows);
        write_reactions(session.draft(), rows);
        write_pictures(session.draft(), calibrated, results);
        write_responses(session.draft(), calibrated, loading, results);
      });
    }
    std::vector<LoadCase> cases;
    for (const auto &result : results)
      cases.push_back(result.load_case);
    write_exports(scene, calibrated, loading.held, cases, session);
    check_completeness(results, judges, session.output_directory());
    const std::string first =
      calibrated.networks.front().name +
      suffix_of(results.front().networks.front().kinematics);
    session.say_at_the_end("comparison.csv is the table above; open " + first +
                           ".pvd and fem.pvd in ParaView and apply Warp By "
                           "Vector.");
  }

  template void
  compare<2, 2>(const Scene<2> &, Session &);
  template void
  compare<2, 3>(const Scene<3> &, Session &);
  template void
  compare<3, 3>(const Scene<3> &, Session &);
} // namespace springfit
