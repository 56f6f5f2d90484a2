#include <springfit/comparison/errors.h>
#include <springfit/core/error.h>
#include <springfit/core/incomplete_error.h>
#include <springfit/core/progress.h>
#include <springfit/motion/critical_step.h>
#include <springfit/studies/case_in_motion.h>
#include <springfit/studies/unstable_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

    template <int spacedim>
    TimeGrid
    make_grid(const DynamicsSettings<spacedim> &settings, const double step)
    {
      const double exact = (settings.end - settings.begin) / step;
      const double round = std::round(exact);
      return {settings.begin,
              step,
              static_cast<std::uint64_t>(std::abs(exact - round) < 1e-6 * exact
                                           ? round
                                           : std::ceil(exact))};
    }

    /** None: nothing was solved. */
    std::optional<double>
    mean_iterations(const MovingModel::Solutions &solutions)
    {
      if (solutions.n == 0)
        return {};
      return static_cast<double>(solutions.n_iterations) / solutions.n;
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

  template <int dim, int spacedim>
  CaseInMotion<dim, spacedim>::CaseInMotion(
    const Scene<spacedim> &scene,
    const CalibratedScene<dim, spacedim> &calibrated,
    const Loading &loading,
    const LoadCase &load_case,
    Session &session)
    : scene_(scene)
    , calibrated_(calibrated)
    , settings_(scene.dynamics.settings())
    , name_(load_case.name)
    , session_(session)
    , excitation_(
        make_excitation(scene, calibrated, loading, load_case, settings_))
    , remains_(everything(*calibrated.mesh))
    , models_(
        make_moving_models(scene, calibrated, settings_, excitation_, remains_))
    , observations_(observations(settings_,
                                 *calibrated.mesh,
                                 calibrated.element,
                                 loading,
                                 excitation_.obstacles))
    , grid_(make_grid(settings_, choose_step()))
  {
    // What cannot be opened is said before the motion begins.
    Remains remains = remains_;
    for (const Opening &opening : settings_.openings)
      remains = opened(opening, *calibrated.mesh, remains);
  }

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::begin()
  {
    for (const auto &model : models_)
      records_.push_back(std::make_unique<MotionRecord>(session_.draft(),
                                                        base(*model),
                                                        observations_));
    observe();
    show();
  }

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::resume(CheckpointReader &checkpoint)
  {
    checkpoint >> n_done_;
    while (n_done_ > 0 && opens(n_done_ - 1))
      open();
    for (auto &model : models_)
      {
        auto &account = model->account;
        checkpoint >> model->state.time >> model->state.displacement >>
          model->state.velocity >> model->state.acceleration >>
          model->acceleration >> model->solutions.n >>
          model->solutions.n_iterations >> account.work_of_loads >>
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

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::save(CheckpointWriter &checkpoint) const
  {
    checkpoint << n_done_;
    for (std::size_t m = 0; m < models_.size(); ++m)
      {
        const auto &model   = *models_[m];
        const auto &account = model.account;
        checkpoint << model.state.time << model.state.displacement
                   << model.state.velocity << model.state.acceleration
                   << model.acceleration << model.solutions.n
                   << model.solutions.n_iterations << account.work_of_loads
                   << account.work_of_contact << account.work_of_supports
                   << account.dissipated << model.seconds << model.square_sum
                   << model.largest_error << model.largest << model.n_rows;
        records_[m]->save(checkpoint);
      }
  }

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::run(const Limits &limits,
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
        while (opens(n_done_))
          open();
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

  template <int dim, int spacedim>
  std::vector<MotionSummary>
  CaseInMotion<dim, spacedim>::summary() const
  {
    const double largest = models_.front()->largest;
    const auto &x        = excitation_.nodes;
    const double rounding =
      1e-12 * (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
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
                        mean_iterations(model->solutions),
                        model->largest,
                        {}});
        if (settings_.has_finite_elements && largest > rounding)
          rows.back().errors = {100. *
                                  std::sqrt(model->square_sum /
                                            (model->n_rows *
                                             excitation_.nodes.cols())) /
                                  largest,
                                100. * model->largest_error / largest};
      }
    return rows;
  }

  template <int dim, int spacedim>
  std::vector<std::string>
  CaseInMotion<dim, spacedim>::files() const
  {
    std::vector<std::string> files;
    for (const auto &record : records_)
      for (const auto &file : record->files())
        files.push_back(file);
    return files;
  }

  template <int dim, int spacedim>
  std::string
  CaseInMotion<dim, spacedim>::base(const MovingModel &model) const
  {
    return name_ + '_' + model.name;
  }

  template <int dim, int spacedim>
  double
  CaseInMotion<dim, spacedim>::choose_step() const
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

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::check_step(MovingModel &model,
                                          const double step) const
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
          limiting_motion(
            calibrated_.networks, model, excitation_.nodes, critical.shape) +
          '.',
        "Set a smaller step, or 0 for nine tenths of the limit; or choose "
        "'Integrator = implicit euler', which bears any.");
  }

  template <int dim, int spacedim>
  bool
  CaseInMotion<dim, spacedim>::opens(const std::uint64_t n_done) const
  {
    return n_opened_ < settings_.openings.size() &&
           settings_.openings[n_opened_].time <
             grid_.time(n_done) + 1e-6 * grid_.step;
  }

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::open()
  {
    const auto &mesh   = *calibrated_.mesh;
    const auto opening = settings_.openings[n_opened_++];
    remains_           = opened(opening, mesh, remains_);

    excitation_.lost_nodes = remains_.lost_nodes;
    for (std::size_t v = 0; v < remains_.lost_nodes.size(); ++v)
      if (remains_.lost_nodes[v])
        for (int d = 0; d < spacedim; ++d)
          excitation_.held[spacedim * v + d] = true;
    auto models =
      make_moving_models(scene_, calibrated_, settings_, excitation_, remains_);
    for (std::size_t m = 0; m < models.size(); ++m)
      go_on_from(*models_[m], excitation_, *models[m]);
    models_ = std::move(models);
    session_.log("Load case " + name_ + ": cells are taken out where " +
                 opening.condition + " at t = " + text_of(opening.time) +
                 " s.");
  }

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::step()
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

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::check_limits(const Limits &limits) const
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

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::stop(const std::string &reason) const
  {
    throw IncompleteError(
      "Load case " + name_ + " ended at t = " + text_of(grid_.time(n_done_)) +
      " s, " + reason + " What was found until then is in " +
      session_.output_directory().string() + '.');
  }

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::observe()
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

  template <int dim, int spacedim>
  void
  CaseInMotion<dim, spacedim>::show()
  {
    if (settings_.frame_interval > 0.)
      for (std::size_t m = 0; m < models_.size(); ++m)
        records_[m]->add_frame(*models_[m], *calibrated_.mesh, remains_);
  }

  template class CaseInMotion<2>;
  template class CaseInMotion<2, 3>;
  template class CaseInMotion<3>;
} // namespace springfit
