#ifndef springfit_motion_step_preconditioner_h
#define springfit_motion_step_preconditioner_h

#include <springfit/motion/moving_body.h>

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

    /** That of the matrix with the tangent at @p displacement from now on. */
    virtual void
    build(const Eigen::MatrixXd &displacement,
          double mass_factor,
          double stiffness_factor) = 0;

    /** Sets @p motion to what it makes of @p forces; dim x n_nodes. */
    virtual void
    apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &motion) = 0;
  };

  // The body must outlive them.

  /** A V cycle on the scalar matrix, see scalar_step_matrix(). */
  std::unique_ptr<StepPreconditioner>
  multigrid_preconditioner(int dim, const MovingBody &body);

  /**
   * The exact inverse at the displacement by L D L^T factors; where the matrix
   * is not positive definite there, that with the convex tangent.
   */
  std::unique_ptr<StepPreconditioner>
  factor_preconditioner(int dim, const MovingBody &body);
} // namespace springfit

#endif
