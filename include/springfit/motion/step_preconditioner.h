#ifndef springfit_motion_step_preconditioner_h
#define springfit_motion_step_preconditioner_h

#include <springfit/motion/moving_body.h>
#include <springfit/motion/step_system.h>

#include <Eigen/Core>

#include <memory>

namespace springfit
{
  /**
   * A symmetric positive definite approximation of the inverse of an implicit
   * step's matrix, see step_matrix.h, that serves for many steps.
   */
  class StepPreconditioner
  {
  public:
    virtual ~StepPreconditioner() = default;

    /**
     * That of the matrix at a state from now on; whether that is positive
     * definite, without which there is none.
     */
    virtual bool
    build(const MotionState &state,
          const StepFactors &factors,
          Tangent tangent) = 0;

    /**
     * Of what it is the inverse of, without the loads' stiffness: the mean
     * entry on the diagonal of each node, or nothing where that counts already.
     */
    virtual Eigen::VectorXd
    diagonal_without_loads() const = 0;

    /** Sets @p motion to what it makes of @p forces; dim x n_nodes. */
    virtual void
    apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &motion) = 0;
  };

  // The body must outlive them.

  /** A V cycle on the scalar matrix, see scalar_step_matrix(). */
  std::unique_ptr<StepPreconditioner>
  multigrid_preconditioner(int dim, const MovingBody &body);

  /** L D L^T factors in single precision: exact up to that. */
  std::unique_ptr<StepPreconditioner>
  factor_preconditioner(int dim, const MovingBody &body);
} // namespace springfit

#endif
