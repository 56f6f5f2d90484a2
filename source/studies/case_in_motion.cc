#include <springfit/comparison/errors.h>
#include <springfit/core/error.h>
#include <springfit/core/incomplete_error.h>
#include <springfit/core/progress.h>
#include <springfit/motion/critical_step.h>
#include <springfit/studies/case_in_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>

namespace springfit
{
  namespace
  {
    std::string
    text_of(const double value)
    {
      std::ostringstream text;
      text.precision(4);
      text << value;
      return text.str();
    }

    template <int dim>
    TimeGrid
    make_grid(const DynamicsSettings<dim> &settings, const double step)
    {
      const double exact = (settings.end - settings.begin) / step;
      const double round = std::round(exact);
      return {settings.begin,
              step,
              static_cast<std::uint64_t>(std::abs(exact - round) < 1e-6 * exact
                                           ? round
                                           : std::ceil(exact))};
    }

    /** Of conjugate gradients for each solution; none: nothing was solved. */
    std::optional<double>
    mean_iterations(const MovingModel &model)
    {
      const auto &n = model.system->n_iterations();
      if (n.empty())
        return {};
      return std::accumulate(n.begin(), n.end(), 0.) / n.size();
    }

    /** The node that moves most, in words. */
    std::string
    fastest_node(const Eigen::MatrixXd &shape, const Eigen::MatrixXd &nodes)
    {
      Eigen::Index v;
      shape.colwise().norm().maxCoeff(&v);
      std::ostringstream text;
      text.precision(4);
      text << "node " << v << " at (";
      for (Eigen::Index d = 0; d < nodes.rows(); ++d)
        text << (d > 0 ? ", " : "") << nodes(d, v);
      text << ") m";
      return text.str();
    }

    /** The spring that resists a motion most, in words; none: nothing. */
    std::string
    stiffest_member(const std::vector<CalibratedNetwork> &networks,
                    const MovingModel &model,
                    const Eigen::MatrixXd &x,
                    const Eigen::MatrixXd &shape)
    {
      std::string words;
      double largest = 0.;
      for (const auto &network : networks)
        if (model.name.compare(0, network.name.size(), network.name) == 0 &&
            model.fit == network.fit && model.enrichment == network.enrichment)
          for (const auto &family : network.network.families)
            for (std::size_t m = 0; m < family.size(); ++m)
              {
                const unsigned int *nodes = family.nodes(m);
                const unsigned int n      = family.kind->n_nodes();
                const std::vector<unsigned int> of_member(nodes, nodes + n);
                const Eigen::VectorXd u =
                  shape(Eigen::all, of_member).reshaped();
                if (u.isZero(0.))
                  continue;
                const double energy =
                  u.dot(family.kind->hessian(family.members, m, x) * u);
                if (energy > largest)
                  {
                    largest = energy;
                    words   = " and most of all by the nodes";
                    for (const unsigned int v : of_member)
                      words += ' ' + std::to_string(v);
                    words += " of " + family.kind->word();
                  }
              }
      return words;
    }
  } // namespace

  double
  TimeGrid::time(const std::uint64_t i) const
  {
    return begin + i * step;
  }

  std::uint64_t
  TimeGrid::steps_in(const double interval) const
  {
    return interval > 0.
             ? std::max<std::uint64_t>(1, std::llround(interval / step))
             : 0;
  }

  template <int dim>
  CaseInMotion<dim>::CaseInMotion(const Scene<dim> &scene,
                                  const CalibratedScene<dim> &calibrated,
                                  const Loading &loading,
                                  const LoadCase &load_case,
                                  Session &session)
    : settings_(scene.dynamics.settings())
    , mesh_(*calibrated.mesh)
    , networks_(calibrated.networks)
    , name_(load_case.name)
    , session_(session)
    , excitation_(
        make_excitation(scene, calibrated, loading, load_case, settings_))
    , models_(make_moving_models(scene, calibrated, settings_, excitation_))
    , observations_(observations(settings_,
                                 mesh_,
                                 calibrated.element,
                                 loading,
                                 excitation_.obstacles))
    , grid_(make_grid(settings_, choose_step()))
  {}

  template <int dim>
  void
  CaseInMotion<dim>::begin()
  {
    for (const auto &model : models_)
      records_.push_back(std::make_unique<MotionRecord>(session_.draft(),
                                                        base(*model),
                                                        observations_));
    observe();
    show();
  }

  template <int dim>
  void
  CaseInMotion<dim>::resume(CheckpointReader &checkpoint)
  {
    checkpoint >> n_done_;
    for (auto &model : models_)
      {
        auto &account = model->account;
        checkpoint >> model->state.time >> model->state.displacement >>
          model->state.velocity >> model->state.acceleration >>
          model->acceleration >> account.work_of_loads >>
          account.work_of_contact >> account.work_of_supports >>
          account.dissipated >> model->seconds >> model->square_sum >>
          model->largest_error >> model->largest >> model->n_rows;
        set_forces(excitation_, *model);
        model->system->forget();
        records_.push_back(std::make_unique<MotionRecord>(
          session_.draft(), base(*model), observations_, checkpoint));
      }
    session_.print("Load case " + name_ +
                   " goes on from its checkpoint at t = " +
                   text_of(grid_.time(n_done_)) + " s.");
  }

  template <int dim>
  void
  CaseInMotion<dim>::save(CheckpointWriter &checkpoint) const
  {
    checkpoint << n_done_;
    for (std::size_t m = 0; m < models_.size(); ++m)
      {
        const auto &model   = *models_[m];
        const auto &account = model.account;
        checkpoint << model.state.time << model.state.displacement
                   << model.state.velocity << model.state.acceleration
                   << model.acceleration << account.work_of_loads
                   << account.work_of_contact << account.work_of_supports
                   << account.dissipated << model.seconds << model.square_sum
                   << model.largest_error << model.largest << model.n_rows;
        records_[m]->save(checkpoint);
      }
  }

  template <int dim>
  void
  CaseInMotion<dim>::run(const Limits &limits,
                         const std::function<void()> &make_checkpoint)
  {
    const auto rows_every =
      std::max<std::uint64_t>(1, grid_.steps_in(settings_.table_interval));
    const auto frames_every = grid_.steps_in(settings_.frame_interval);
    const auto checkpoints_every =
      grid_.steps_in(settings_.checkpoint_interval);
    Progress progress("Steps of " + name_, grid_.n_steps, session_.is_root());
    for (std::uint64_t i = 0; i < n_done_; ++i)
      progress.step();
    while (n_done_ < grid_.n_steps)
      {
        check_limits(limits);
        step();
        ++n_done_;
        const bool is_last = n_done_ == grid_.n_steps;
        if (n_done_ % rows_every == 0 || is_last)
          observe();
        if (frames_every > 0 && (n_done_ % frames_every == 0 || is_last))
          show();
        if (checkpoints_every > 0 && n_done_ % checkpoints_every == 0)
          {
            make_checkpoint();
            // As a run that goes on from here.
            for (const auto &model : models_)
              model->system->forget();
          }
        progress.step();
      }
  }

  template <int dim>
  std::vector<MotionSummary>
  CaseInMotion<dim>::summary() const
  {
    const double largest = models_.front()->largest;
    std::vector<MotionSummary> rows;
    for (const auto &model : models_)
      {
        rows.push_back({name_,
                        model->fit,
                        model->enrichment,
                        model->kinematics,
                        grid_.n_steps,
                        grid_.step,
                        model->critical_step,
                        model->seconds / grid_.n_steps,
                        mean_iterations(*model),
                        model->largest,
                        {}});
        if (settings_.has_finite_elements && largest > 0.)
          rows.back().errors = {100. *
                                  std::sqrt(model->square_sum /
                                            (model->n_rows *
                                             excitation_.nodes.cols())) /
                                  largest,
                                100. * model->largest_error / largest};
      }
    return rows;
  }

  template <int dim>
  std::vector<std::string>
  CaseInMotion<dim>::files() const
  {
    std::vector<std::string> files;
    for (const auto &record : records_)
      for (const auto &file : record->files())
        files.push_back(file);
    return files;
  }

  template <int dim>
  std::string
  CaseInMotion<dim>::base(const MovingModel &model) const
  {
    return name_ + '_' + model.name;
  }

  template <int dim>
  double
  CaseInMotion<dim>::choose_step() const
  {
    if (settings_.integrator != Integrator::symplectic_euler)
      {
        for (const auto &model : models_)
          session_.log(model->name + ": " + model->reason);
        return settings_.step;
      }
    double largest = std::numeric_limits<double>::infinity();
    for (const auto &model : models_)
      {
        check_step(*model, settings_.step);
        session_.print("The largest stable step of symplectic Euler's method "
                       "is " +
                       text_of(*model->critical_step) + " s for the model '" +
                       model->name + "'.");
        largest = std::min(largest, *model->critical_step);
      }
    return settings_.step > 0. ? settings_.step : 0.9 * largest;
  }

  template <int dim>
  void
  CaseInMotion<dim>::check_step(MovingModel &model, const double step) const
  {
    const auto critical = critical_step(model.body, model.state.displacement);
    if (!std::isfinite(critical.step))
      throw EntryError("Dynamics/Integrator",
                       "nothing resists in the model '" + model.name +
                         "', which has no stability limit.",
                       "Choose another one.");
    model.critical_step = critical.step;
    if (step > critical.step)
      throw EntryError(
        "Dynamics/Time step",
        text_of(step) + " s is beyond the stability limit " +
          text_of(critical.step) +
          " s of symplectic Euler's method for the model '" + model.name +
          "' at t = " + text_of(model.state.time) + " s, set by " +
          fastest_node(critical.shape, excitation_.nodes) +
          stiffest_member(networks_,
                          model,
                          excitation_.nodes + model.state.displacement,
                          critical.shape) +
          '.',
        "Set a smaller step, or 0 for nine tenths of the limit; or choose "
        "'Integrator = implicit euler', which bears any.");
  }

  template <int dim>
  void
  CaseInMotion<dim>::step()
  {
    const double end = grid_.time(n_done_ + 1);
    for (const auto &model : models_)
      try
        {
          if (settings_.integrator == Integrator::symplectic_euler &&
              settings_.steps_between_checks > 0 && n_done_ > 0 &&
              n_done_ % settings_.steps_between_checks == 0)
            check_step(*model, grid_.step);
          advance(settings_, grid_.step, end, excitation_, *model);
        }
      catch (const std::runtime_error &error)
        {
          stop("in the model '" + model->name + "': " + error.what());
        }
  }

  template <int dim>
  void
  CaseInMotion<dim>::check_limits(const Limits &limits) const
  {
    const std::chrono::duration<double> passed =
      std::chrono::steady_clock::now() - limits.begin;
    const bool is_late =
      settings_.time_limit > 0. && passed.count() > settings_.time_limit;
    if (is_late || limits.interruption.is_asked_for())
      stop(
        std::string(is_late ? "at its 'Time limit'." : "by a signal to stop.") +
        (settings_.checkpoint_interval > 0.
           ? " The same command goes on from the last checkpoint."
           : " With a 'Checkpoint interval' in section Dynamics the same "
             "command would go on."));
  }

  template <int dim>
  void
  CaseInMotion<dim>::stop(const std::string &reason) const
  {
    throw IncompleteError(
      "Load case " + name_ + " ended at t = " + text_of(grid_.time(n_done_)) +
      " s, " + reason + " What was found until then is in " +
      session_.output_directory().string() + '.');
  }

  template <int dim>
  void
  CaseInMotion<dim>::observe()
  {
    const auto &reference = models_.front()->state.displacement;
    for (std::size_t m = 0; m < models_.size(); ++m)
      {
        auto &model = *models_[m];
        records_[m]->add_row(model, excitation_);
        const Eigen::VectorXd errors =
          nodal_errors(reference, model.state.displacement);
        model.square_sum += errors.squaredNorm();
        model.largest_error = std::max(model.largest_error, errors.maxCoeff());
        model.largest =
          std::max(model.largest,
                   largest_displacement(model.state.displacement));
        ++model.n_rows;
      }
  }

  template <int dim>
  void
  CaseInMotion<dim>::show()
  {
    if (settings_.frame_interval > 0.)
      for (std::size_t m = 0; m < models_.size(); ++m)
        records_[m]->add_frame(*models_[m], mesh_);
  }

  template class CaseInMotion<2>;
  template class CaseInMotion<3>;
} // namespace springfit
