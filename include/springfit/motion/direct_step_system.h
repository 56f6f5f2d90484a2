#ifndef springfit_motion_direct_step_system_h
#define springfit_motion_direct_step_system_h

#include <springfit/motion/block_factors.h>
#include <springfit/motion/step_matrix.h>
#include <springfit/motion/step_system.h>

#include <memory>
#include <vector>

namespace springfit
{
  /** By factors of each step's matrix: exact, for any matrix. */
  class DirectStepSystem : public StepSystem
  {
  public:
    /** @p body must outlive the object. */
    DirectStepSystem(int dim, const MovingBody &body);

    void
    linearise(const MotionState &state) override;

    void
    linearise_loads(const MotionState &state) override;

    Eigen::MatrixXd
    stiffness_product(const Eigen::MatrixXd &u) const override;

    Eigen::MatrixXd
    solve(const StepFactors &factors, const Eigen::MatrixXd &forces) override;

    Eigen::MatrixXd
    correct(const StepFactors &factors,
            const Eigen::MatrixXd &forces,
            double norm) override;

    void
    forget() override;

    const std::vector<unsigned int> &
    n_iterations() const override;

  private:
    const MovingBody &body_;
    StepMatrix matrix_;
    const std::unique_ptr<BlockFactors> factors_;

    bool are_factorised_ = false;
    StepFactors of_factors_{};
    std::vector<unsigned int> n_iterations_;
  };
} // namespace springfit

#endif
