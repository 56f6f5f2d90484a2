#include <springfit/motion/meet_obstacles.h>

#include <algorithm>

namespace springfit
{
  namespace
  {
    /** The loads at a state as linear functions of the displacement. */
    class LinearLoads
    {
    public:
      LinearLoads(const MovingBody &body, const MotionState &state)
        : displacement_(state.displacement)
        , forces_(
            Eigen::MatrixXd::Zero(displacement_.rows(), displacement_.cols()))
        , blocks_(
            Eigen::MatrixXd::Zero(displacement_.rows(), displacement_.size()))
      {
        body.loads(state, forces_);
        body.load_stiffness(state, blocks_);
      }

      const Eigen::MatrixXd &
      forces() const
      {
        return forces_;
      }

      Eigen::MatrixXd
      forces_at(const Eigen::MatrixXd &displacement) const
      {
        const Eigen::Index dim = displacement.rows();
        Eigen::MatrixXd forces = forces_;
        for (Eigen::Index v = 0; v < displacement.cols(); ++v)
          forces.col(v) -= blocks_.middleCols(dim * v, dim) *
                           (displacement.col(v) - displacement_.col(v));
        return forces;
      }

    private:
      Eigen::MatrixXd displacement_, forces_, blocks_;
    };

    // Obstacles are met and left within a few solutions.
    constexpr unsigned int most_meetings = 10;

    // Of the loads: what a step with one linearisation need not know better.
    constexpr double exact_enough = 3e-3;

    // No shorter part of a correction is taken.
    constexpr double least_part = 0.125;
  } // namespace


  void
  meet_obstacles(const MovingBody &body,
                 StepSystem &system,
                 const StepFactors &factors,
                 const double norm,
                 const double tolerance,
                 const double step,
                 const MotionState &begin,
                 Eigen::MatrixXd &y)
  {
    MotionState end  = begin;
    end.displacement = begin.displacement + step * y;
    LinearLoads loads(body, end);
    Eigen::MatrixXd rest =
      step *
      (loads.forces() - LinearLoads(body, begin).forces_at(end.displacement));
    for (unsigned int i = 0; i < most_meetings; ++i)
      {
        const double size = norm_of_free(body, rest);
        const double enough =
          std::max(tolerance * norm,
                   exact_enough * step * norm_of_free(body, loads.forces()));
        if (!(size > enough))
          return;
        system.linearise_loads(end);
        const Eigen::MatrixXd change = system.correct(factors, rest, norm);
        for (double part = 1.;; part *= 0.5)
          {
            MotionState trial = end;
            trial.displacement += part * step * change;
            const LinearLoads there(body, trial);
            const Eigen::MatrixXd left =
              (1. - part) * rest +
              step * (there.forces() - loads.forces_at(trial.displacement));
            if (!(norm_of_free(body, left) < size) && part > least_part)
              continue;
            y += part * change;
            end   = trial;
            loads = there;
            rest  = left;
            break;
          }
      }
  }
} // namespace springfit
