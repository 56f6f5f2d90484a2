#include <springfit/calibration/cell_fits.h>
#include <springfit/comparison/uniaxial_test.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/progress.h>
#include <springfit/fit/fit.h>
#include <springfit/output/sweep_table.h>
#include <springfit/reference/cell_frame.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/study.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    /** A stiffness for the test, and what it stands for. */
    struct TestedModel
    {
      std::string fit;
      std::string enrichment;
      Eigen::MatrixXd stiffness; // N/m
      unsigned int n_negative;
    };

    /** The stiffness of what a fit made of the cell: R without what it misses.
     */
    TestedModel
    fit_cell(const FitProblem &problem,
             const Method &method,
             const FitOptions &options)
    {
      const FitResult result = fit(problem, method, options);
      check_certificate(result, options);
      return {name_of(method),
              name_of(options.enrichment),
              problem.stiffness - residual(problem, result),
              result.n_negative};
    }

    /** The one cell of the mesh. */
    template <int dim>
    typename dealii::Triangulation<dim>::active_cell_iterator
    single_cell(const Mesh<dim> &mesh)
    {
      const unsigned int n_cells = mesh.triangulation.n_active_cells();
      if (n_cells != 1)
        throw EntryError("Geometry/Object",
                         "it has " + std::to_string(n_cells) +
                           " cells, but a sweep tests a single one.",
                         "Set 'Object = cell', or a 'Cell size' as large as "
                         "the object.");
      return mesh.triangulation.begin_active();
    }

    /** Test the finite element and every fit of a cell of one material. */
    template <int dim>
    class CellTest
    {
    public:
      CellTest(const Scene<dim> &scene, const CalibratedScene<dim> &mesh)
        : scene_(scene)
        , kind_(mesh.mesh->cell_kind)
        , cell_(single_cell(*mesh.mesh))
        , points_(cell_points<dim>(cell_))
        , matrices_(mesh.element)
        , integrated_gradients_(mesh.materials.begin()->second.thickness *
                                matrices_.integrated_gradients(cell_))
      {}

      void
      append_rows(const YoungPoisson &in, std::vector<SweepRow> &rows)
      {
        const auto material = scene_.material.with_constants(
          {in.youngs_modulus, in.poissons_ratio, 1.});
        const auto problem =
          cell_problem<dim>(cell_, kind_, matrices_, material);

        rows.push_back(test(in, {"fem", "none", problem.stiffness, 0}));
        for (const auto &row : scene_.fit.rows(kind_))
          {
            const std::string fit = row.method->word;
            for (const auto &assumption : unmet_assumptions(
                   *row.method, points_, kind_, problem.material))
              unmet_[{fit, assumption}].insert(
                {in.youngs_modulus, in.poissons_ratio});
            try
              {
                rows.push_back(test(
                  in, fit_cell(problem, *row.method, scene_.fit.options(row))));
              }
            catch (const RunError &error)
              {
                std::ostringstream text;
                text << "The fit '" << fit
                     << "' of the cell with E = " << in.youngs_modulus
                     << " Pa, nu = " << in.poissons_ratio << " failed:";
                throw RunError(text.str(), error.what());
              }
          }
      }

      /** Warn of published fits whose assumptions did not hold. */
      void
      warn(Session &session) const
      {
        for (const auto &[what, materials] : unmet_)
          session.warn("The constants of '" + what.first +
                       "' are published for " + what.second + ", which " +
                       std::to_string(materials.size()) +
                       " of the cells tested do not meet. They are used all "
                       "the same.");
      }

    private:
      SweepRow
      test(const YoungPoisson &in, const TestedModel &model) const
      {
        const auto plane_state = scene_.material.plane_state();

        auto out = uniaxial_test(model.stiffness,
                                 points_,
                                 integrated_gradients_,
                                 scene_.sweep_range.axis());
        if (out && dim == 2 && plane_state == PlaneState::strain)
          out = from_plane_strain(*out);

        const auto part = isotropic_part(
          affine_tensor(model.stiffness, points_, integrated_gradients_));
        return {model.fit,
                model.enrichment,
                in,
                out,
                dim == 2 && plane_state == PlaneState::stress
                  ? young_poisson_plane_stress(part.lambda, part.mu)
                  : young_poisson(part.lambda, part.mu),
                model.n_negative};
      }

      const Scene<dim> &scene_;
      const CellKind kind_;
      const typename dealii::Triangulation<dim>::active_cell_iterator cell_;
      const Eigen::MatrixXd points_;
      CellMatrices<dim> matrices_;
      const Eigen::MatrixXd integrated_gradients_;

      /** Fit and assumption, and the materials (E, nu) that do not meet it. */
      std::map<std::pair<std::string, std::string>,
               std::set<std::pair<double, double>>>
        unmet_;
    };

    struct Range
    {
      double lowest  = std::numeric_limits<double>::infinity();
      double highest = -std::numeric_limits<double>::infinity();

      /** Rounding errors of 0 are not worth a sign. */
      void
      include(double value)
      {
        value   = std::abs(value) < 1e-12 ? 0. : value;
        lowest  = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    };

    /** What a model delivers over the whole sweep. */
    std::string
    summary_line(const std::string &fit,
                 const std::string &enrichment,
                 const std::vector<SweepRow> &rows)
    {
      Range ratio, nu, homogenised;
      unsigned int n_slack = 0;
      for (const auto &row : rows)
        if (row.fit == fit && row.enrichment == enrichment)
          {
            homogenised.include(row.homogenised.poissons_ratio);
            if (row.out)
              {
                ratio.include(row.out->youngs_modulus / row.in.youngs_modulus);
                nu.include(row.out->poissons_ratio);
              }
            else
              ++n_slack;
          }

      char text[200];
      const std::string name = name_of(fit, enrichment);
      std::snprintf(text, sizeof(text), "%-20s", name.c_str());
      std::string line = text;
      for (const Range &range : {ratio, nu, homogenised})
        {
          if (range.lowest <= range.highest)
            std::snprintf(text,
                          sizeof(text),
                          "  %8.4f .. %8.4f",
                          range.lowest,
                          range.highest);
          else
            std::snprintf(text, sizeof(text), "  %20s", "-");
          line += text;
        }
      if (n_slack > 0)
        line += "  (" + std::to_string(n_slack) + " without resistance)";
      return line;
    }
  } // namespace

  template <int dim>
  void
  sweep(const Scene<dim> &scene, Session &session)
  {
    const auto mesh = make_scene<dim, dim>(scene, session);
    CellTest<dim> cell_test(scene, mesh);
    const auto youngs_moduli   = scene.sweep_range.youngs_moduli();
    const auto poissons_ratios = scene.sweep_range.poissons_ratios();

    dealii::TimerOutput::Scope scope(session.timer(), "Sweep");
    std::vector<SweepRow> rows;
    run_on_root(session.communicator(), [&]() {
      Progress progress("Tests of the cell",
                        youngs_moduli.size() * poissons_ratios.size(),
                        true);
      for (const double modulus : youngs_moduli)
        for (const double ratio : poissons_ratios)
          {
            cell_test.append_rows({modulus, ratio}, rows);
            progress.step();
          }
      write_sweep(session.draft(), rows);

      session.print(
        "A tensile test of the cell, over all materials:\n"
        "fit                         E_out / E_in                nu_out"
        "        nu_homogenised");
      session.print(summary_line("fem", "none", rows));
      for (const auto &row : scene.fit.rows(mesh.mesh->cell_kind))
        session.print(
          summary_line(name_of(*row.method), name_of(row.enrichment), rows));
      cell_test.warn(session);
    });
    session.say_at_the_end("sweep.csv is what the cell delivers, E_out and "
                           "nu_out, for each E_in and nu_in.");
  }

  template void
  sweep<2>(const Scene<2> &, Session &);
  template void
  sweep<3>(const Scene<3> &, Session &);
} // namespace springfit
