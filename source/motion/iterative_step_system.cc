#include <springfit/motion/iterative_step_system.h>

#include <cmath>
#include <utility>

namespace springfit
{
  namespace
  {
    // Above this factors are cheaper, or rounding errors in the way.
    constexpr unsigned int most_iterations = 500;

    // Of iterations, as many times those with a new preconditioner and some
    // more: to build one takes as long as many iterations.
    constexpr double outworn_factor = 2., outworn_more = 10.;

    std::vector<Eigen::Index>
    held_unknowns(const MovingBody &body)
    {
      std::vector<Eigen::Index> held;
      for (std::size_t i = 0; i < body.held.size(); ++i)
        if (body.held[i])
          held.push_back(i);
      return held;
    }

    void
    set_zero(const std::vector<Eigen::Index> &unknowns, Eigen::MatrixXd &values)
    {
      for (const Eigen::Index i : unknowns)
        values.data()[i] = 0.;
    }
  } // namespace


  IterativeStepSystem::IterativeStepSystem(
    const int dim,
    const MovingBody &body,
    std::unique_ptr<StepPreconditioner> preconditioner,
    const double tolerance)
    : dim_(dim)
    , body_(body)
    , preconditioner_(std::move(preconditioner))
    , tolerance_(tolerance)
    , tangent_(body.elastic->tangent_operator())
    , held_(held_unknowns(body))
  {}


  void
  IterativeStepSystem::linearise(const MotionState &state)
  {
    tangent_->linearise(state.displacement);
    state_ = state;
    if (body_.load_stiffness)
      {
        load_blocks_.setZero(dim_, dim_ * body_.mass.size());
        body_.load_stiffness(state, load_blocks_);
      }
  }


  Eigen::MatrixXd
  IterativeStepSystem::stiffness_product(const Eigen::MatrixXd &u) const
  {
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(u.rows(), u.cols());
    tangent_->add_product(u, product);
    return product;
  }


  void
  IterativeStepSystem::multiply(const Eigen::MatrixXd &u,
                                Eigen::MatrixXd &product) const
  {
    product.setZero(u.rows(), u.cols());
    tangent_->add_product(u, product);
    if (body_.consistent_mass.nonZeros() > 0)
      product =
        factors_.stiffness * product + factors_.mass * mass_product(body_, u);
    else
      for (Eigen::Index v = 0; v < u.cols(); ++v)
        product.col(v) = factors_.stiffness * product.col(v) +
                         factors_.mass * body_.mass[v] * u.col(v);
    if (body_.load_stiffness)
      for (Eigen::Index v = 0; v < u.cols(); ++v)
        product.col(v) += factors_.load_stiffness *
                          (load_blocks_.middleCols(dim_ * v, dim_) * u.col(v));
    if (are_there(body_.dampers))
      product += factors_.dampers *
                 damper_product(body_.dampers, state_.displacement, u);
    set_zero(held_, product);
  }


  void
  IterativeStepSystem::prepare(const StepFactors &factors)
  {
    const bool is_another =
      factors.mass != factors_.mass || factors.stiffness != factors_.stiffness;
    factors_ = factors;
    if (is_another)
      {
        solutions_.clear();
        preconditioner_->build(Eigen::MatrixXd::Zero(dim_, body_.mass.size()),
                               factors.mass,
                               factors.stiffness);
      }
    else if (is_outworn_)
      preconditioner_->build(state_.displacement,
                             factors.mass,
                             factors.stiffness);
    else
      return;
    first_effort_ = 0.;
    is_outworn_   = false;
  }


  Eigen::MatrixXd
  IterativeStepSystem::guess(Eigen::MatrixXd &residual) const
  {
    if (solutions_.empty())
      return Eigen::MatrixXd::Zero(residual.rows(), residual.cols());
    // The parabola through the last three of equal steps goes on to this; its
    // multiple is the one of the least error in the norm of the matrix, so that
    // no guess is worse than 0.
    Eigen::MatrixXd next = solutions_[0];
    if (solutions_.size() == 3)
      next = 3. * (solutions_[0] - solutions_[1]) + solutions_[2];
    Eigen::MatrixXd of_next;
    multiply(next, of_next);
    const double curvature = next.reshaped().dot(of_next.reshaped());
    const double factor =
      curvature > 0. ? next.reshaped().dot(residual.reshaped()) / curvature
                     : 0.;
    residual -= factor * of_next;
    return factor * next;
  }


  void
  IterativeStepSystem::judge(const ConjugateGradients &result)
  {
    // A few iterations say little.
    const double decades = -std::log10(result.reduction);
    if (!result.has_converged || decades < 1.)
      return;
    const double effort = result.n_iterations / decades;
    if (first_effort_ == 0.)
      first_effort_ = effort;
    is_outworn_ = result.n_iterations >
                  outworn_factor * first_effort_ * decades + outworn_more;
  }


  Eigen::MatrixXd
  IterativeStepSystem::solve_directly(const Eigen::MatrixXd &forces)
  {
    if (!direct_)
      direct_ = std::make_unique<DirectStepSystem>(dim_, body_);
    direct_->linearise(state_);
    return direct_->solve(factors_, forces);
  }


  Eigen::MatrixXd
  IterativeStepSystem::solve(const StepFactors &factors,
                             const Eigen::MatrixXd &forces)
  {
    prepare(factors);
    Eigen::MatrixXd residual = forces;
    set_zero(held_, residual);
    const double norm = residual.norm();
    if (!std::isfinite(norm))
      return residual; // what it leads to is for the caller to refuse
    Eigen::MatrixXd solution = guess(residual);
    const ConjugateGradients result =
      conjugate_gradients([&](const auto &u,
                              auto &product) { multiply(u, product); },
                          [&](const auto &r, auto &z) {
                            preconditioner_->apply(r, z);
                            set_zero(held_, z);
                          },
                          tolerance_ * norm,
                          most_iterations,
                          solution,
                          residual);
    n_iterations_.push_back(result.n_iterations);
    judge(result);
    if (!result.has_converged)
      solution = solve_directly(forces);
    solutions_.push_front(solution);
    if (solutions_.size() > 3)
      solutions_.pop_back();
    return solution;
  }


  void
  IterativeStepSystem::forget()
  {
    factors_ = {};
    solutions_.clear();
    first_effort_ = 0.;
    is_outworn_   = false;
  }


  const std::vector<unsigned int> &
  IterativeStepSystem::n_iterations() const
  {
    return n_iterations_;
  }
} // namespace springfit
