#ifndef springfit_motion_direct_step_system_h
#define springfit_motion_direct_step_system_h

#include <springfit/motion/step_system.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/SparseCholesky>

namespace springfit
{
  /** By a sparse L D L^T factorisation: exact, for small bodies. */
  class DirectStepSystem : public StepSystem
  {
  public:
    /** @p body must outlive the object. */
    DirectStepSystem(int dim, const MovingBody &body);

    void
    linearise(const MotionState &state) override;

    Eigen::MatrixXd
    stiffness_product(const Eigen::MatrixXd &u) const override;

    Eigen::MatrixXd
    solve(const StepFactors &factors, const Eigen::MatrixXd &forces) override;

  private:
    void
    factorise(const StepFactors &factors);

    const int dim_;
    const MovingBody &body_;

    // All of one pattern.
    TangentMatrix tangent_, mass_, load_stiffness_, dampers_;

    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
    bool are_factorised_ = false;
    StepFactors of_factors_{};
  };
} // namespace springfit

#endif
