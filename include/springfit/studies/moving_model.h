#ifndef springfit_studies_moving_model_h
#define springfit_studies_moving_model_h

#include <springfit/motion/contact.h>
#include <springfit/motion/dynamics.h>
#include <springfit/motion/energy_account.h>
#include <springfit/motion/moving_body.h>
#include <springfit/motion/step_system.h>
#include <springfit/response/load_case.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What a load case does to every model alike. */
  struct Excitation
  {
    Eigen::MatrixXd nodes;  // at rest, dim x n_nodes, m
    std::vector<bool> held; // a flag per unknown
    std::function<NodalLoad(double time)> load;
    std::vector<Obstacle> obstacles;

    /** A flag per node: no cell has it, and no obstacle touches it. */
    std::vector<bool> lost_nodes;
  };

  /**
   * Where obstacles look for the nodes, m: those that are lost are infinitely
   * far away.
   */
  Eigen::MatrixXd
  places(const Excitation &excitation, const Eigen::MatrixXd &displacement);


  /** A model in motion. It refers to itself and stays where it is. */
  struct MovingModel
  {
    MovingModel() = default;

    MovingModel(const MovingModel &) = delete;
    MovingModel &
    operator=(const MovingModel &) = delete;

    // As in tables; the name is that of files.
    std::string name, fit, enrichment, kinematics;

    std::unique_ptr<const ElasticBody> elastic;
    MovingBody body;
    std::unique_ptr<StepSystem> system;
    std::string reason; // why it is this system, for the log

    MotionState state;
    Eigen::MatrixXd acceleration; // m/s^2, of the last step
    ForcesInMotion forces;        // in the state
    EnergyAccount account;

    double seconds = 0.; // wall time of all steps

    /** Of the equations of all steps, and conjugate gradients' iterations. */
    struct Solutions
    {
      std::uint64_t n = 0, n_iterations = 0;
    };
    Solutions solutions;

    /** The stability limit of symplectic Euler's method, s, if it was asked
     * for.
     */
    std::optional<double> critical_step;

    // Its distance from the finite elements, over all rows of its table.
    double square_sum    = 0.; // m^2, of all nodes
    double largest_error = 0.; // m
    double largest       = 0.; // m: its own displacement
    std::uint64_t n_rows = 0;
  };

  /**
   * Let a model whose elastic body, masses and damping are set start at rest,
   * but for what the supports move: that has the velocity of the first
   * @p interval, s. @p excitation must outlive the model.
   */
  void
  start(double time,
        double interval,
        const Excitation &excitation,
        MovingModel &model);

  /**
   * Let a model that has just been started go on where an earlier one of the
   * same nodes ends. Nodes that are lost are put to rest; the energy that is
   * lost with them, and with what held them, is dissipated.
   */
  void
  go_on_from(const MovingModel &earlier,
             const Excitation &excitation,
             MovingModel &model);

  /** Those in the state that a model is in, with its acceleration. */
  void
  set_forces(const Excitation &excitation, MovingModel &model);

  /**
   * One step of the method that the settings name, which ends at @p end, s.
   *
   * @throws RunError when it fails: the model is as before the step.
   */
  template <int dim>
  void
  advance(const DynamicsSettings<dim> &settings,
          double step,
          double end,
          const Excitation &excitation,
          MovingModel &model);
} // namespace springfit

#endif
