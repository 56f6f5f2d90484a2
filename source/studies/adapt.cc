#include <springfit/comparison/errors.h>
#include <springfit/comparison/rungs.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/output/adapt_table.h>
#include <springfit/output/mesh_vtu.h>
#include <springfit/output/network_vtu.h>
#include <springfit/output/tables.h>
#include <springfit/response/distributed_body.h>
#include <springfit/response/finite_element_body.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/measured_model.h>
#include <springfit/studies/mixed_body.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/network_exports.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/study.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    // What a richer model does to the displacements is not foreseen.
    constexpr double safety = 0.7;

    /** What the error is of: a linear function of the displacements' error. */
    struct Goal
    {
      Eigen::MatrixXd weights;   // of displacements
      Eigen::MatrixXd of_forces; // of missing forces where it is held
    };

    /** All that a load case tells of a mixed body. */
    struct JudgedCase
    {
      Equilibrium found;
      Eigen::MatrixXd contributions; // n_cells x n_models, per cent, signed
      double estimate;               // per cent, signed
    };

    template <int dim, int spacedim>
    class Adaptation
    {
    public:
      Adaptation(const Scene<spacedim> &scene,
                 const CalibratedScene<dim, spacedim> &calibrated,
                 const Loading &loading,
                 const AdaptSettings &settings,
                 Session &session)
        : scene_(scene)
        , calibrated_(calibrated)
        , loading_(loading)
        , settings_(settings)
        , law_(scene.statics.material_law())
        , kinematics_(law_ == MaterialLaw::linear ? Kinematics::linear
                                                  : Kinematics::nonlinear)
        , discretization_(*calibrated.mesh,
                          loading.held,
                          session.communicator())
        , mixed_(calibrated, law_, kinematics_)
        , exact_(mixed_.exact_body())
      {
        if (settings_.quantity)
          quantity_ = on_mesh(*settings_.quantity,
                              *calibrated.mesh,
                              calibrated.element,
                              loading,
                              "Adapt/Quantity");
      }

      const MixedBody<dim, spacedim> &
      mixed() const
      {
        return mixed_;
      }

      Kinematics
      kinematics() const
      {
        return kinematics_;
      }

      unsigned int
      n_models() const
      {
        return mixed_.n_models() - (settings_.has_finite_elements ? 0 : 1);
      }

      std::vector<Equilibrium>
      respond(std::unique_ptr<const BodyOfMembers> body) const
      {
        const auto model = scene_.statics.body(discretization_,
                                               *calibrated_.mesh,
                                               calibrated_.element,
                                               std::move(body),
                                               {"the mixed network",
                                                "Load less, or leave out the "
                                                "first of the fits."},
                                               kinematics_);
        std::vector<Equilibrium> found;
        for (const auto &load_case : loading_.cases)
          {
            found.push_back(model->respond(load_case.load));
            if (!is_complete(found.back()))
              throw RunError("Load case " + load_case.name + ": " +
                               found.back().failure,
                             "Load less, or leave out the first of the fits.");
            // It throws where nothing moves.
            scale_of(load_case, loading_, found.back().displacement);
          }
        return found;
      }

      /**
       * That of the quantity in all load cases, m or N: symmetry may forbid it
       * in some. 1 without a quantity.
       *
       * @throws EntryError when it is 0.
       */
      double
      largest_quantity(const std::vector<Equilibrium> &found) const
      {
        if (!quantity_)
          return 1.;
        double largest = 0., scale = 0.;
        for (const auto &of_case : found)
          {
            largest =
              std::max(largest, std::abs(value_of(*quantity_, of_case)));
            scale = std::max(scale,
                             (quantity_->is_reaction ? of_case.reactions
                                                     : of_case.displacement)
                               .cwiseAbs()
                               .maxCoeff());
          }
        if (!(largest > 1e-9 * scale))
          throw EntryError("Adapt/Quantity",
                           "no load moves it.",
                           "Name another component, or a place that moves.");
        return largest;
      }

      /** The error between two equilibria of a load case, per cent. */
      double
      error(const Equilibrium &exact,
            const Equilibrium &found,
            const double largest) const
      {
        if (quantity_)
          return 100. *
                 (value_of(*quantity_, exact) - value_of(*quantity_, found)) /
                 largest;
        return error_norms(exact.displacement, found.displacement)
          .e_rms_percent;
      }

      /** The estimate by one step of Newton's method for the exact body. */
      JudgedCase
      judge(const Equilibrium &found,
            const std::vector<unsigned int> &models,
            const double largest) const
      {
        const Eigen::MatrixXd &u   = found.displacement;
        const unsigned int n_cells = models.size();
        if (!std::isfinite(exact_->energy(u)))
          throw RunError(
            "The finite elements have no energy in the state of "
            "the mixed network.",
            "Load less, or set 'Material law = stable neo-hookean' "
            "in section Response.");
        std::vector<std::vector<Eigen::MatrixXd>> missing(n_cells);
        Eigen::MatrixXd sum = 0. * u;
        for (unsigned int c = 0; c < n_cells; ++c)
          {
            missing[c] = mixed_.missing_forces(c, u);
            add(missing[c][models[c]], c, sum);
          }

        typename Discretization<spacedim>::Matrix tangent;
        discretization_.initialize(tangent);
        DistributedBody<spacedim> distributed(discretization_, *exact_);
        distributed.tangent(u, tangent);
        const auto solver =
          scene_.statics.linear_solvers(discretization_)(tangent);
        const auto solve = [&](const Eigen::MatrixXd &forces) {
          return discretization_.to_nodal(
            solver->solve(discretization_.to_vector(forces)));
        };
        const Eigen::MatrixXd change = solve(sum);
        const Goal goal              = this->goal(found, change, largest);
        Eigen::MatrixXd adjoint      = goal.weights;
        if (quantity_ && quantity_->is_reaction)
          {
            adjoint.setZero();
            exact_->add_tangent_product(u, goal.weights, adjoint);
          }
        adjoint = solve(adjoint) - goal.of_forces;

        JudgedCase judged{found, Eigen::MatrixXd(n_cells, n_models()), 0.};
        for (const auto &cell :
             calibrated_.mesh->triangulation.active_cell_iterators())
          {
            const unsigned int c = cell->active_cell_index();
            const auto &nodes    = calibrated_.mesh->nodes.of(cell);
            for (unsigned int k = 0; k < n_models(); ++k)
              {
                double product = 0.;
                for (std::size_t a = 0; a < nodes.size(); ++a)
                  product += adjoint.col(nodes[a]).dot(missing[c][k].col(a));
                judged.contributions(c, k) = product;
              }
            judged.estimate += judged.contributions(c, models[c]);
          }
        if (!std::isfinite(judged.estimate))
          throw RunError("The error of the mixed network could not be "
                         "estimated: it is not finite.",
                         "Load less, or leave out the first of the fits.");
        return judged;
      }

    private:
      void
      add(const Eigen::MatrixXd &of_cell,
          const unsigned int cell,
          Eigen::MatrixXd &sum) const
      {
        const auto &nodes = calibrated_.mesh->nodes.of_cells[cell];
        for (std::size_t a = 0; a < nodes.size(); ++a)
          sum.col(nodes[a]) += of_cell.col(a);
      }

      /** In per cent, of the state that is a @p change away. */
      Goal
      goal(const Equilibrium &found,
           const Eigen::MatrixXd &change,
           const double largest_of_quantity) const
      {
        const Eigen::MatrixXd &u = found.displacement;
        Goal goal{0. * u, 0. * u};
        if (quantity_)
          {
            goal.weights = 100. / largest_of_quantity * quantity_->weights;
            if (quantity_->is_reaction)
              goal.of_forces = goal.weights;
            return goal;
          }
        const double largest = largest_displacement(u + change);
        const double error =
          change.norm() / std::sqrt(double(u.cols())) / largest;
        if (error > 0.)
          goal.weights = 100. / (u.cols() * largest * largest * error) * change;
        return goal;
      }

      const Scene<spacedim> &scene_;
      const CalibratedScene<dim, spacedim> &calibrated_;
      const Loading &loading_;
      const AdaptSettings settings_;
      const MaterialLaw law_;
      const Kinematics kinematics_;
      const Discretization<spacedim> discretization_;
      const MixedBody<dim, spacedim> mixed_;
      const std::unique_ptr<const BodyOfMembers> exact_;
      std::optional<Quantity> quantity_;
    };


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
      scene, calibrated, loading, settings, session);
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
      write_models_of_cells(folder, models, names);
      const auto network = adaptation.mixed().network(models);
      write_network(folder, "adapted", network);
      write_network_vtu(folder, "adapted", network, {});
      auto networks = named(calibrated.networks);
      networks.push_back({"adapted", &network});
      write_families(folder, networks);
      Eigen::VectorXd of_cells(n_cells);
      for (unsigned int c = 0; c < n_cells; ++c)
        of_cells[c] = models[c];
      for (std::size_t i = 0; i < judged.size(); ++i)
        {
          Eigen::VectorXd contributions(n_cells);
          for (unsigned int c = 0; c < n_cells; ++c)
            contributions[c] = std::abs(judged[i].contributions(c, models[c]));
          write_mesh_vtu(folder / (loading.cases[i].name + "_adapted.vtu"),
                         *calibrated.mesh,
                         {{"displacement", judged[i].found.displacement}},
                         {{"model", of_cells},
                          {"error_percent", contributions}});
        }
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
