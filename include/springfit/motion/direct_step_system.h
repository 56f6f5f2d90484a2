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
    linearise(const Eigen::MatrixXd &displacement) override;

    Eigen::MatrixXd
    stiffness_product(const Eigen::MatrixXd &u) const override;

    Eigen::MatrixXd
    solve(double mass_factor,
          double stiffness_factor,
          const Eigen::MatrixXd &forces) override;

  private:
    const int dim_;
    const MovingBody &body_;
    TangentMatrix tangent_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;

    // Of the factors; none are there while both are 0.
    double mass_factor_ = 0., stiffness_factor_ = 0.;
  };
} // namespace springfit

#endif
