#include <springfit/calibration/calibration.h>
#include <springfit/core/error.h>
#include <springfit/studies/stability_judge.h>
#include <springfit/studies/verdicts_at_rest.h>
#include <springfit/studies/verdicts_in_motion.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace springfit
{
  namespace
  {
    /** The body without the axes that are states or motions of it. */
    Variation
    body_of(Variation variation)
    {
      for (const auto axis : {StabilityAxis::stretch,
                              StabilityAxis::inversion,
                              StabilityAxis::time_step})
        variation.erase(axis);
      return variation;
    }

    /** Tables have numbers only. */
    void
    drop_what_is_not_finite(StabilityRow &row)
    {
      for (auto *number : {&row.cell_eigenvalue,
                           &row.network_eigenvalue,
                           &row.condition,
                           &row.gap,
                           &row.predicted_step,
                           &row.observed_step,
                           &row.energy_drift,
                           &row.e_rms,
                           &row.youngs_modulus,
                           &row.poissons_ratio,
                           &row.iterations})
        if (*number && !std::isfinite(**number))
          number->reset();
    }

    void
    tell_cells(const CalibratedNetwork &network, StabilityRow &row)
    {
      row.calibration = "accepted";
      row.n_negative  = n_negative(network.network.families);
      for (const auto &cell : network.cells)
        {
          if (const auto gap = cell.result.duality_gap)
            {
              row.calibration = "certified";
              row.gap         = std::max(row.gap.value_or(0.), *gap);
            }
          if (const auto smallest = cell.result.smallest_eigenvalue)
            row.cell_eigenvalue =
              std::min(row.cell_eigenvalue.value_or(*smallest), *smallest);
        }
    }
  } // namespace

  template <int dim, int spacedim>
  StabilityJudge<dim, spacedim>::StabilityJudge(
    const Scene<spacedim> &scene,
    const StabilitySettings &settings,
    Session &session)
    : scene_(scene)
    , settings_(settings)
    , session_(session)
    , kind_(scene.geometry
              .template create<dim>(session.communicator(), scene.folder)
              ->cell_kind)
  {}

  template <int dim, int spacedim>
  std::vector<JudgedModel>
  StabilityJudge<dim, spacedim>::models(const Variation &variation) const
  {
    const bool is_motion = value_of(variation, StabilityAxis::time_step) &&
                           !value_of(variation, StabilityAxis::stretch) &&
                           !value_of(variation, StabilityAxis::inversion);
    const bool is_nonlinear = value_of(variation, StabilityAxis::stretch) ||
                              value_of(variation, StabilityAxis::inversion);
    std::vector<std::optional<Integrator>> integrators(1);
    if (is_motion)
      integrators.assign(settings_.integrators.begin(),
                         settings_.integrators.end());
    std::vector<JudgedModel> models;
    const auto add = [&](const std::optional<std::size_t> &fit,
                         const Kinematics kinematics) {
      if (is_nonlinear && kinematics == Kinematics::linear)
        return;
      for (const auto &integrator : integrators)
        models.push_back({fit, kinematics, integrator});
    };
    add({},
        scene_.statics.material_law() == MaterialLaw::linear
          ? Kinematics::linear
          : Kinematics::nonlinear);
    for (std::size_t f = 0; f < scene_.fit.rows(kind_).size(); ++f)
      for (const auto kinematics : scene_.statics.kinematics())
        add(f, kinematics);
    return models;
  }

  template <int dim, int spacedim>
  StabilityRow
  StabilityJudge<dim, spacedim>::blank_row(const Variation &variation,
                                           const JudgedModel &model) const
  {
    StabilityRow row;
    for (const auto &axis : settings_.axes)
      row.axes.emplace_back(word_of(stability_axis_words(), axis.axis),
                            value_of(variation, axis.axis));
    row.fit        = "fem";
    row.enrichment = "none";
    if (model.fit)
      {
        const auto fit = scene_.fit.rows(kind_)[*model.fit];
        row.fit        = name_of(*fit.method);
        row.enrichment = name_of(fit.enrichment);
      }
    row.kinematics = word_of(kinematics_words(), model.kinematics);
    row.integrator =
      model.integrator ? word_of(integrator_words(), *model.integrator) : "-";
    row.calibration = model.fit ? "refused" : "-";
    return row;
  }

  template <int dim, int spacedim>
  void
  StabilityJudge<dim, spacedim>::set(const Variation &variation)
  {
    const Variation body = body_of(variation);
    if (setting_ && setting_->body == body)
      return;
    fits_.clear();
    setting_.reset();
    setting_ = make_stability_setting<dim>(scene_, body, session_);
  }

  template <int dim, int spacedim>
  StabilityRow
  StabilityJudge<dim, spacedim>::judge(const Variation &variation,
                                       const JudgedModel &model)
  {
    StabilityRow row = blank_row(variation, model);
    try
      {
        set(variation);
        if (model.fit)
          {
            auto &attempt = fits_[*model.fit];
            if (!attempt.network && attempt.failure.empty())
              try
                {
                  attempt.network =
                    calibrate_row(scene_.fit,
                                  scene_.fit.rows(kind_)[*model.fit],
                                  *setting_->varied.mesh,
                                  setting_->varied.element,
                                  setting_->varied.materials,
                                  scene_.statics.material_law(),
                                  session_);
                }
              catch (const RunError &error)
                {
                  attempt.failure = error.what();
                }
            if (!attempt.network)
              {
                refuse(attempt.failure, row);
                return row;
              }
            tell_cells(*attempt.network, row);
          }

        const JudgedBody<dim, spacedim> body{scene_,
                                             *setting_,
                                             model.fit
                                               ? &*fits_.at(*model.fit).network
                                               : nullptr,
                                             model.kinematics};
        if (const auto stretch = value_of(variation, StabilityAxis::stretch))
          judge_stretched(body, *stretch, row);
        else if (const auto edges =
                   value_of(variation, StabilityAxis::inversion))
          judge_inverted(body, *edges, settings_.n_steps, row);
        else if (const auto step =
                   value_of(variation, StabilityAxis::time_step))
          judge_motion(body, *model.integrator, *step, settings_.n_steps, row);
        else
          judge_at_rest(body, settings_.n_steps, row);
      }
    catch (const RunError &error)
      {
        refuse(error.what(), row);
      }
    catch (const InputError &error)
      {
        // A mesh that cannot be, a region that is empty at this size.
        setting_.reset();
        refuse(error.what(), row);
      }
    drop_what_is_not_finite(row);
    return row;
  }

  template class StabilityJudge<2, 2>;
  template class StabilityJudge<2, 3>;
  template class StabilityJudge<3, 3>;
} // namespace springfit
