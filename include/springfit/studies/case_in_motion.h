#ifndef springfit_studies_case_in_motion_h
#define springfit_studies_case_in_motion_h

#include <springfit/core/interruption.h>
#include <springfit/core/session.h>
#include <springfit/motion/checkpoint.h>
#include <springfit/output/motion_table.h>
#include <springfit/response/load_case.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/motion_output.h>
#include <springfit/studies/moving_models.h>
#include <springfit/studies/scene.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  /** The steps of a motion, counted from 0. */
  struct TimeGrid
  {
    double begin, step; // s
    std::uint64_t n_steps;

    double
    time(std::uint64_t i) const;

    /** How many steps an interval has, at least one; 0 of 0 s. */
    std::uint64_t
    steps_in(double interval) const;
  };


  /** All models under one load case, step by step beside each other. */
  template <int dim, int spacedim = dim>
  class CaseInMotion
  {
  public:
    /**
     * The models at rest. The arguments must outlive the object.
     *
     * @throws EntryError when something is wrong at the beginning, or the step
     * is beyond the stability limit of symplectic Euler's method.
     */
    CaseInMotion(const Scene<spacedim> &scene,
                 const CalibratedScene<dim, spacedim> &calibrated,
                 const Loading &loading,
                 const LoadCase &load_case,
                 Session &session);

    /** Begin tables and series. */
    void
    begin();

    /** Or go on with those of a checkpoint, which are in the session's folder.
     */
    void
    resume(CheckpointReader &checkpoint);

    void
    save(CheckpointWriter &checkpoint) const;

    /** When a run has to stop before its end. */
    struct Limits
    {
      const Interruption &interruption;
      std::chrono::steady_clock::time_point begin; // of the run
    };

    /**
     * Go through all steps that are left.
     *
     * @param make_checkpoint is called when the settings want it
     * @throws IncompleteError when a step fails or a limit is reached; what was
     * found is written.
     */
    void
    run(const Limits &limits, const std::function<void()> &make_checkpoint);

    std::vector<MotionSummary>
    summary() const;

    /** All files so far. */
    std::vector<std::string>
    files() const;

  private:
    std::string
    base(const MovingModel &model) const;

    /** That of the settings, or as large as all models bear. */
    double
    choose_step() const;

    /** @throws InputError when @p step is not stable where the model is. */
    void
    check_step(MovingModel &model, double step) const;

    /** Whether an opening is due before the step after @p n_done ones. */
    bool
    opens(std::uint64_t n_done) const;

    /** Take out the cells of the next opening. */
    void
    open();

    void
    step();

    void
    check_limits(const Limits &limits) const;

    [[noreturn]] void
    stop(const std::string &reason) const;

    /** A row of each table, and the distances from the finite elements. */
    void
    observe();

    void
    show();

    const Scene<spacedim> &scene_;
    const CalibratedScene<dim, spacedim> &calibrated_;
    const DynamicsSettings<spacedim> settings_;
    const std::string name_;
    Session &session_;
    Excitation excitation_;
    Remains remains_;
    std::size_t n_opened_ = 0;
    std::vector<std::unique_ptr<MovingModel>> models_;
    const Observations observations_;
    const TimeGrid grid_;
    std::vector<std::unique_ptr<MotionRecord>> records_;
    std::uint64_t n_done_ = 0;
  };
} // namespace springfit

#endif
