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
        : body_(body), tangent_(empty_step_matrix(dim, body))
      {
        factors_.analyzePattern(tangent_.matrix());
      }

      void
      build(const Eigen::MatrixXd &displacement,
            const double mass_factor,
            const double stiffness_factor) override
      {
        const auto factorise = [&]() {
          factors_.factorize(
            step_matrix(body_, tangent_, mass_factor, stiffness_factor));
          return factors_.info() == Eigen::Success &&
                 factors_.vectorD().minCoeff() > 0.;
        };
        tangent_.set_zero();
        body_.elastic->add_tangent(displacement, tangent_);
        are_there_ = factorise();
        if (are_there_)
          return;
        tangent_.set_zero();
        body_.elastic->add_convex_tangent(displacement, tangent_);
        are_there_ = factorise();
      }

      void
      apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &motion) override
      {
        if (!are_there_)
          {
            motion = forces;
            return;
          }
        const Eigen::VectorXd solution = factors_.solve(forces.reshaped());
        motion = solution.reshaped(forces.rows(), forces.cols());
      }

    private:
      const MovingBody &body_;
      TangentMatrix tangent_;
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
      bool are_there_ = false; // otherwise the unit matrix
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
