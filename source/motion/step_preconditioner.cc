#include <springfit/motion/multigrid.h>
#include <springfit/motion/step_matrix.h>
#include <springfit/motion/step_preconditioner.h>

#include <Eigen/SparseCholesky>

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

      void
      build(const Eigen::MatrixXd &displacement,
            const double mass_factor,
            const double stiffness_factor) override
      {
        multigrid_ = std::make_unique<Multigrid>(scalar_step_matrix(
          dim_, body_, displacement, mass_factor, stiffness_factor));
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
    };


    class FactorPreconditioner : public StepPreconditioner
    {
    public:
      FactorPreconditioner(const int dim, const MovingBody &body)
        : dim_(dim), body_(body)
      {}

      void
      build(const Eigen::MatrixXd &displacement,
            const double mass_factor,
            const double stiffness_factor) override
      {
        auto factors           = std::make_unique<Factors>(step_matrix(
          dim_, body_, displacement, mass_factor, stiffness_factor));
        const bool is_positive = factors->info() == Eigen::Success &&
                                 factors->vectorD().minCoeff() > 0.;
        if (is_positive)
          factors_ = std::move(factors);
      }

      void
      apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &motion) override
      {
        if (!factors_)
          {
            motion = forces;
            return;
          }
        const Eigen::VectorXd solution = factors_->solve(forces.reshaped());
        motion = solution.reshaped(forces.rows(), forces.cols());
      }

    private:
      using Factors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

      const int dim_;
      const MovingBody &body_;
      std::unique_ptr<Factors> factors_; // none: the unit matrix
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
