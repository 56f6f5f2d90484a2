#include <springfit/core/error.h>
#include <springfit/motion/direct_step_system.h>

namespace springfit
{
  DirectStepSystem::DirectStepSystem(const int dim, const MovingBody &body)
    : body_(body)
    , matrix_(dim, body)
    , factors_(make_block_factors<double>(dim,
                                          step_pattern(body),
                                          held_nodes(dim, body)))
  {}


  void
  DirectStepSystem::linearise(const MotionState &state)
  {
    are_factorised_ = false;
    matrix_.linearise(state, Tangent::exact);
  }


  void
  DirectStepSystem::linearise_loads(const MotionState &state)
  {
    are_factorised_ = false;
    matrix_.linearise_loads(state);
  }


  Eigen::MatrixXd
  DirectStepSystem::stiffness_product(const Eigen::MatrixXd &u) const
  {
    return matrix_.stiffness_product(u);
  }


  Eigen::MatrixXd
  DirectStepSystem::solve(const StepFactors &factors,
                          const Eigen::MatrixXd &forces)
  {
    if (!are_factorised_ || factors.mass != of_factors_.mass ||
        factors.stiffness != of_factors_.stiffness ||
        factors.load_stiffness != of_factors_.load_stiffness ||
        factors.dampers != of_factors_.dampers)
      {
        factors_->factorise(matrix_.sum(factors));
        if (!factors_->exist())
          throw RunError("The matrix of a step is singular.",
                         "Choose a smaller step.");
        are_factorised_ = true;
        of_factors_     = factors;
      }
    Eigen::MatrixXd solution = forces;
    for (Eigen::Index i = 0; i < solution.size(); ++i)
      if (body_.held[i])
        solution.data()[i] = 0.;
    factors_->solve(solution);
    n_iterations_.push_back(0);
    return solution;
  }


  Eigen::MatrixXd
  DirectStepSystem::correct(const StepFactors &factors,
                            const Eigen::MatrixXd &forces,
                            double)
  {
    return solve(factors, forces);
  }


  void
  DirectStepSystem::forget()
  {}


  const std::vector<unsigned int> &
  DirectStepSystem::n_iterations() const
  {
    return n_iterations_;
  }
} // namespace springfit
