#include <springfit/core/error.h>
#include <springfit/motion/critical_step.h>
#include <springfit/studies/measured_model.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/responses.h>

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace springfit
{
  namespace
  {
    // A measurement goes on for so long, but for so many steps at most.
    constexpr double enough_seconds   = 0.05;
    constexpr unsigned int most_steps = 200;

    // What takes longer is measured once.
    constexpr double too_long_to_repeat = 1.;

    double
    quantile(std::vector<double> values, const double part)
    {
      std::sort(values.begin(), values.end());
      return values[std::min<std::size_t>(values.size() - 1,
                                          part * values.size())];
    }

    std::optional<double>
    median(const std::vector<double> &values)
    {
      if (values.empty())
        return {};
      return quantile(values, 0.5);
    }

    /** What the program holds, MiB. */
    double
    memory_in_use()
    {
      const auto heap = mallinfo2();
      return (heap.uordblks + heap.hblkhd) / 1048576.;
    }
  } // namespace

  Meter::Meter()
    : begin_(std::chrono::steady_clock::now()), memory_(memory_in_use())
  {}

  double
  Meter::seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         begin_)
      .count();
  }

  double
  Meter::mebibytes() const
  {
    return memory_in_use() - memory_;
  }

  template <int spacedim>
  MeasuredModel<spacedim>::MeasuredModel(
    TradeoffRow known,
    std::unique_ptr<MovingModel> model,
    std::function<std::unique_ptr<Model>()> make_statics)
    : row(std::move(known))
    , model_(std::move(model))
    , make_statics_(std::move(make_statics))
  {}

  template <int spacedim>
  std::vector<Equilibrium>
  MeasuredModel<spacedim>::respond(const std::vector<NodalLoad> &loads)
  {
    std::vector<Equilibrium> found;
    try
      {
        const auto statics = make_statics_();
        for (const auto &load : loads)
          {
            found.push_back(statics->respond(load));
            if (!is_complete(found.back()))
              {
                row.failure = found.back().failure;
                return found;
              }
          }
        first_load_ = loads.front();
        solve_seconds_.push_back(found.front().seconds);
      }
    catch (const RunError &error)
      {
        row.failure = error.what();
      }
    return found;
  }

  template <int spacedim>
  double
  MeasuredModel<spacedim>::energy(const Eigen::MatrixXd &displacement) const
  {
    return model_->elastic->energy(displacement) -
           model_->elastic->energy(0. * displacement);
  }

  template <int spacedim>
  void
  MeasuredModel<spacedim>::set_in_motion(
    const DynamicsSettings<spacedim> &settings,
    Excitation &excitation)
  {
    excitation_ = &excitation;
    const Meter meter;
    try
      {
        springfit::set_in_motion(settings, excitation, *model_);
        implicit_ = {settings, settings.step, model_->state, {}};
        const MotionState at_rest = model_->state;
        advance(settings,
                settings.step,
                model_->state.time + settings.step,
                excitation,
                *model_);
        row.setup       = row.setup.value_or(0.) + meter.seconds();
        row.memory      = row.memory.value_or(0.) + meter.mebibytes();
        implicit_.state = model_->state;

        explicit_.settings            = settings;
        explicit_.settings.integrator = Integrator::symplectic_euler;
        explicit_.state               = at_rest;
        const double stable =
          critical_step(model_->body, at_rest.displacement).step;
        if (std::isfinite(stable))
          {
            row.stable_step = stable;
            explicit_.step  = 0.5 * stable;
          }
      }
    catch (const RunError &error)
      {
        row.failure    = error.what();
        implicit_.step = explicit_.step = 0.;
      }
  }

  template <int spacedim>
  void
  MeasuredModel<spacedim>::measure(Steps &steps)
  {
    if (steps.step == 0. ||
        (!steps.seconds.empty() && steps.seconds[0] > too_long_to_repeat))
      return;
    model_->state       = steps.state;
    const double before = model_->seconds;
    try
      {
        unsigned int n = 0;
        while (n < most_steps && model_->seconds - before < enough_seconds)
          {
            advance(steps.settings,
                    steps.step,
                    model_->state.time + steps.step,
                    *excitation_,
                    *model_);
            ++n;
          }
        steps.seconds.push_back((model_->seconds - before) / n);
        steps.state = model_->state;
      }
    catch (const RunError &error)
      {
        row.failure = error.what();
        steps       = {};
      }
  }

  template <int spacedim>
  void
  MeasuredModel<spacedim>::measure_again()
  {
    if (!solve_seconds_.empty() && solve_seconds_[0] < too_long_to_repeat)
      solve_seconds_.push_back(make_statics_()->respond(first_load_).seconds);
    measure(implicit_);
    measure(explicit_);
  }

  template <int spacedim>
  void
  MeasuredModel<spacedim>::finish()
  {
    row.solve         = median(solve_seconds_);
    row.implicit_step = median(implicit_.seconds);
    row.explicit_step = median(explicit_.seconds);
    for (const auto &times :
         {solve_seconds_, implicit_.seconds, explicit_.seconds})
      if (times.size() > 1)
        row.spread =
          std::max(row.spread.value_or(0.),
                   50. * (quantile(times, 0.75) - quantile(times, 0.25)) /
                     quantile(times, 0.5));
  }

  template class MeasuredModel<2>;
  template class MeasuredModel<3>;
} // namespace springfit
