#include <springfit/motion/iterative_step_system.h>
#include <springfit/response/convex_tangent.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
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

    // What is pressed stays so for a while.
    constexpr unsigned int n_convex_linearisations = 10;

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
    const PreconditionerLife life,
    const double tolerance,
    const WhereIndefinite where)
    : dim_(dim)
    , body_(body)
    , preconditioner_(std::move(preconditioner))
    , life_(life)
    , tolerance_(tolerance)
    , tangent_(body.elastic->tangent_operator())
    , where_indefinite_(where)
    , stiffness_(tangent_.get())
    , mass_of_unknowns_(body.mass.transpose().replicate(dim, 1).reshaped())
    , held_(held_unknowns(body))
  {}


  void
  IterativeStepSystem::linearise(const MotionState &state)
  {
    stiffness_ = n_convex_ > 0 ? convex_tangent_.get() : tangent_.get();
    if (n_convex_ > 0)
      --n_convex_;
    stiffness_->linearise(state.displacement);
    state_ = state;
    if (life_ == PreconditionerLife::short_one)
      is_outworn_ = true;
    linearise_loads(state);
  }


  void
  IterativeStepSystem::linearise_loads(const MotionState &state)
  {
    if (!body_.load_stiffness)
      return;
    state_of_loads_ = state;
    load_blocks_.setZero(dim_, dim_ * body_.mass.size());
    body_.load_stiffness(state, load_blocks_);
    touched_.clear();
    for (Eigen::Index v = 0; v < body_.mass.size(); ++v)
      if (!load_blocks_.middleCols(dim_ * v, dim_).isZero(0.))
        touched_.push_back(v);
  }


  Eigen::MatrixXd
  IterativeStepSystem::stiffness_product(const Eigen::MatrixXd &u) const
  {
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(u.rows(), u.cols());
    stiffness_->add_product(u, product);
    return product;
  }


  void
  IterativeStepSystem::multiply(const Eigen::MatrixXd &u,
                                Eigen::MatrixXd &product) const
  {
    product.setZero(u.rows(), u.cols());
    stiffness_->add_product(u, product);
    if (body_.consistent_mass.nonZeros() > 0)
      product =
        factors_.stiffness * product + factors_.mass * mass_product(body_, u);
    else
      {
        // reshaped() would not be vectorised.
        Eigen::Map<Eigen::VectorXd> all(product.data(), product.size());
        const Eigen::Map<const Eigen::VectorXd> motion(u.data(), u.size());
        all = factors_.stiffness * all +
              factors_.mass * mass_of_unknowns_.cwiseProduct(motion);
      }
    if (body_.load_stiffness)
      for (const Eigen::Index v : touched_)
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
        MotionState rest;
        rest.displacement.setZero(dim_, body_.mass.size());
        rest.velocity = rest.displacement;
        build_preconditioner(life_ == PreconditionerLife::long_one ? rest
                                                                   : state_);
      }
    else if (is_outworn_)
      build_preconditioner(state_);
  }


  void
  IterativeStepSystem::build_preconditioner(const MotionState &state)
  {
    first_effort_ = 0.;
    is_outworn_   = false;
    is_positive_ =
      !is_convex() && preconditioner_->build(state, factors_, Tangent::exact);
    if (is_positive_)
      return;
    // What has no factors is not solved by iterations, either.
    if (life_ == PreconditionerLife::short_one && !is_convex() &&
        where_indefinite_ == WhereIndefinite::convex_tangent)
      take_convex_tangent();
    is_positive_ = preconditioner_->build(state, factors_, Tangent::convex);
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


  bool
  IterativeStepSystem::is_convex() const
  {
    return stiffness_ != tangent_.get();
  }


  void
  IterativeStepSystem::take_convex_tangent()
  {
    if (!convex_tangent_)
      convex_tangent_ = convex_tangent_operator(*body_.elastic);
    n_convex_  = n_convex_linearisations;
    stiffness_ = convex_tangent_.get();
    stiffness_->linearise(state_.displacement);
  }


  Eigen::MatrixXd
  IterativeStepSystem::solve_directly(const Eigen::MatrixXd &forces)
  {
    if (!direct_)
      direct_ = std::make_unique<DirectStepSystem>(dim_, body_);
    direct_->linearise(state_);
    if (body_.load_stiffness)
      direct_->linearise_loads(state_of_loads_);
    return direct_->solve(factors_, forces);
  }


  unsigned int
  IterativeStepSystem::n_iterations_to_try() const
  {
    if (first_effort_ == 0.)
      return most_iterations;
    const double expected = -std::log10(tolerance_) * first_effort_;
    return std::min<double>(most_iterations,
                            2. * (outworn_factor * expected + outworn_more));
  }


  void
  IterativeStepSystem::set_scales()
  {
    scales_.clear();
    const Eigen::VectorXd diagonal = preconditioner_->diagonal_without_loads();
    if (!body_.load_stiffness || diagonal.size() == 0)
      return;
    for (const Eigen::Index v : touched_)
      {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> B(
          load_blocks_.middleCols(dim_ * v, dim_));
        const Eigen::VectorXd factors =
          (1. + factors_.load_stiffness / diagonal[v] *
                  B.eigenvalues().array().max(0.))
            .rsqrt();
        scales_.push_back(B.eigenvectors() * factors.asDiagonal() *
                          B.eigenvectors().transpose());
      }
  }


  void
  IterativeStepSystem::scale_touched(Eigen::MatrixXd &values) const
  {
    for (std::size_t i = 0; i < scales_.size(); ++i)
      values.col(touched_[i]) = (scales_[i] * values.col(touched_[i])).eval();
  }


  void
  IterativeStepSystem::precondition(const Eigen::MatrixXd &forces,
                                    Eigen::MatrixXd &motion) const
  {
    if (!is_positive_)
      motion = forces;
    else if (scales_.empty())
      preconditioner_->apply(forces, motion);
    else
      {
        Eigen::MatrixXd scaled = forces;
        scale_touched(scaled);
        preconditioner_->apply(scaled, motion);
        scale_touched(motion);
      }
  }


  std::optional<Eigen::MatrixXd>
  IterativeStepSystem::solve_iteratively(const double norm,
                                         Eigen::MatrixXd solution,
                                         Eigen::MatrixXd residual)
  {
    set_scales();
    const ConjugateGradients result =
      conjugate_gradients([&](const auto &u,
                              auto &product) { multiply(u, product); },
                          [&](const auto &r, auto &z) {
                            precondition(r, z);
                            set_zero(held_, z);
                          },
                          tolerance_ * norm,
                          n_iterations_to_try(),
                          solution,
                          residual);
    n_iterations_.push_back(result.n_iterations);
    judge(result);
    if (!result.has_converged)
      return {};
    return solution;
  }


  std::optional<Eigen::MatrixXd>
  IterativeStepSystem::solve_iteratively(const Eigen::MatrixXd &forces)
  {
    Eigen::MatrixXd residual = forces;
    Eigen::MatrixXd start    = guess(residual);
    return solve_iteratively(forces.norm(),
                             std::move(start),
                             std::move(residual));
  }


  Eigen::MatrixXd
  IterativeStepSystem::solve(const StepFactors &factors,
                             const Eigen::MatrixXd &forces)
  {
    prepare(factors);
    Eigen::MatrixXd free_forces = forces;
    set_zero(held_, free_forces);
    if (!std::isfinite(free_forces.norm()))
      return free_forces; // what it leads to is for the caller to refuse
    auto solution = solve_iteratively(free_forces);
    if (!solution && where_indefinite_ == WhereIndefinite::convex_tangent &&
        !is_convex())
      {
        take_convex_tangent();
        solution = solve_iteratively(free_forces);
      }
    if (!solution && first_effort_ > 0.)
      {
        build_preconditioner(state_);
        solution = solve_iteratively(free_forces);
      }
    if (!solution)
      solution = solve_directly(forces);
    solutions_.push_front(*solution);
    if (solutions_.size() > 3)
      solutions_.pop_back();
    return *solution;
  }


  Eigen::MatrixXd
  IterativeStepSystem::correct(const StepFactors &factors,
                               const Eigen::MatrixXd &forces,
                               const double norm)
  {
    prepare(factors);
    Eigen::MatrixXd free_forces = forces;
    set_zero(held_, free_forces);
    if (!std::isfinite(free_forces.norm()))
      return free_forces;
    const auto correction =
      solve_iteratively(norm, 0. * free_forces, free_forces);
    const Eigen::MatrixXd result =
      correction ? *correction : solve_directly(free_forces);
    // The whole is what a step to come may begin with.
    if (!solutions_.empty())
      solutions_.front() += result;
    return result;
  }


  void
  IterativeStepSystem::forget()
  {
    factors_ = {};
    solutions_.clear();
    first_effort_ = 0.;
    is_outworn_   = false;
    n_convex_     = 0;
  }


  const std::vector<unsigned int> &
  IterativeStepSystem::n_iterations() const
  {
    return n_iterations_;
  }
} // namespace springfit
