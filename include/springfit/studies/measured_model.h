#ifndef springfit_studies_measured_model_h
#define springfit_studies_measured_model_h

#include <springfit/comparison/tradeoff.h>
#include <springfit/motion/dynamics.h>
#include <springfit/response/model.h>
#include <springfit/studies/moving_model.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  /** Time and memory from its construction on. */
  class Meter
  {
  public:
    Meter();

    double
    seconds() const;

    /** What the program has taken of the heap since then. */
    double
    mebibytes() const;

  private:
    std::chrono::steady_clock::time_point begin_;
    double memory_;
  };


  /**
   * What a model costs: a solution of statics and steps in time, each measured
   * again and again.
   */
  template <int spacedim>
  class MeasuredModel
  {
  public:
    /** Its row in the table, to which the times are added by finish(). */
    TradeoffRow row;

    /**
     * @param row what is known without solving anything
     * @param model without a system of equations
     * @param make_statics makes the model that solves statics
     */
    MeasuredModel(TradeoffRow row,
                  std::unique_ptr<MovingModel> model,
                  std::function<std::unique_ptr<Model>()> make_statics);

    /**
     * The equilibrium under each load, with the time of the first; the row has
     * the failure of one that is not complete, and no more are sought.
     */
    std::vector<Equilibrium>
    respond(const std::vector<NodalLoad> &loads);

    /** Its elastic energy without that at rest, J. */
    double
    energy(const Eigen::MatrixXd &displacement) const;

    /**
     * Let it move from rest, with implicit steps as the settings have them and
     * explicit ones; @p excitation must outlive it. A failure is in the row.
     */
    void
    set_in_motion(const DynamicsSettings<spacedim> &settings,
                  Excitation &excitation);

    /** Some more measurements: about 50 ms each of what is fast. */
    void
    measure_again();

    /** Write the medians into the row. */
    void
    finish();

  private:
    struct Steps
    {
      DynamicsSettings<spacedim> settings;
      double step = 0.; // s; 0: there are none
      MotionState state;
      std::vector<double> seconds; // of a step, of each measurement
    };

    void
    measure(Steps &steps);

    std::unique_ptr<MovingModel> model_;
    std::function<std::unique_ptr<Model>()> make_statics_;
    std::vector<double> solve_seconds_;
    NodalLoad first_load_;
    Excitation *excitation_ = nullptr;
    Steps implicit_, explicit_;
  };
} // namespace springfit

#endif
