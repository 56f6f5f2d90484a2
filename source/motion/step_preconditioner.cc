#include <springfit/motion/block_factors.h>
#include <springfit/motion/multigrid.h>
#include <springfit/motion/step_matrix.h>
#include <springfit/motion/step_preconditioner.h>

namespace springfit
{
  namespace
  {
    class MultigridPreconditioner : public StepPreconditioner
    {
    public:
      MultigridPreconditioner(const int dim, const MovingBody &body)
        : dim_(dim), body_(body)
      {}

      // The Laplacian of any tangent is positive definite.
      bool
      build(const MotionState &state,
            const StepFactors &factors,
            Tangent) override
      {
        const auto matrix = scalar_step_matrix(
          dim_, body_, state.displacement, factors.mass, factors.stiffness);
        diagonal_  = matrix.diagonal();
        multigrid_ = std::make_unique<Multigrid>(matrix);
        return true;
      }

      Eigen::VectorXd
      diagonal_without_loads() const override
      {
        return diagonal_;
      }

      void
      apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &motion) override
      {
        multigrid_->apply(forces, motion);
      }

    private:
      const int dim_;
      const MovingBody &body_;
      std::unique_ptr<Multigrid> multigrid_;
      Eigen::VectorXd diagonal_;
    };


    class FactorPreconditioner : public StepPreconditioner
    {
    public:
      FactorPreconditioner(const int dim, const MovingBody &body)
        : matrix_(dim, body)
        , factors_(make_block_factors<float>(dim,
                                             step_pattern(body),
                                             held_nodes(dim, body)))
      {}

      bool
      build(const MotionState &state,
            const StepFactors &factors,
            const Tangent tangent) override
      {
        matrix_.linearise(state, tangent);
        factors_->factorise(matrix_.sum(factors));
        return factors_->are_positive();
      }

      Eigen::VectorXd
      diagonal_without_loads() const override
      {
        return {};
      }

      void
      apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &motion) override
      {
        motion = forces;
        factors_->solve(motion);
      }

    private:
      StepMatrix matrix_;
      const std::unique_ptr<BlockFactors> factors_;
    };
  } // namespace


  std::unique_ptr<StepPreconditioner>
  multigrid_preconditioner(const int dim, const MovingBody &body)
  {
    return std::make_unique<MultigridPreconditioner>(dim, body);
  }


  std::unique_ptr<StepPreconditioner>
  factor_preconditioner(const int dim, const MovingBody &body)
  {
    return std::make_unique<FactorPreconditioner>(dim, body);
  }
} // namespace springfit
