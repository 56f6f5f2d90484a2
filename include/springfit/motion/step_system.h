#ifndef springfit_motion_step_system_h
#define springfit_motion_step_system_h

#include <springfit/motion/moving_body.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * What each part of a body weighs in the matrix of a step. They are those of
   * M, of the elastic tangent K, of the loads' stiffness, and of the dampers.
   */
  struct StepFactors
  {
    double mass;
    double stiffness;
    double load_stiffness;
    double dampers;
  };


  /** Which tangent stiffness of the springs or cells. */
  enum class Tangent
  {
    exact,
    convex // see ElasticBody::add_convex_tangent
  };


  /** What a step does where its matrix is not positive definite. */
  enum class WhereIndefinite
  {
    /** It is solved all the same, by factors. */
    factors,

    /**
     * It is solved with the convex tangent: that leads downhill, which is
     * enough for a single linearisation.
     */
    convex_tangent
  };


  /**
   * What an implicit step asks for: products with the tangent stiffness K at a
   * state, and solutions with sums of the masses M and K.
   */
  class StepSystem
  {
  public:
    virtual ~StepSystem() = default;

    /** All matrices are those at this state from now on. */
    virtual void
    linearise(const MotionState &state) = 0;

    /** The loads' stiffness alone is that at this state from now on. */
    virtual void
    linearise_loads(const MotionState &state) = 0;

    /** K u, N, of the elastic tangent alone. */
    virtual Eigen::MatrixXd
    stiffness_product(const Eigen::MatrixXd &u) const = 0;

    /**
     * y of (the sum of the matrices, each times its factor) y = @p forces, 0
     * where held.
     *
     * @throws RunError when the matrix is singular.
     */
    virtual Eigen::MatrixXd
    solve(const StepFactors &factors, const Eigen::MatrixXd &forces) = 0;

    /**
     * The same of forces that a solution leaves over, as exactly as if @p norm
     * were that of all of them, N.
     */
    virtual Eigen::MatrixXd
    correct(const StepFactors &factors,
            const Eigen::MatrixXd &forces,
            double norm) = 0;

    /**
     * Forget what solutions before have taught, so that all that follows is as
     * with a new system.
     */
    virtual void
    forget() = 0;

    /**
     * Of conjugate gradients, for each solution up to now; those by factors
     * alone have 0.
     */
    virtual const std::vector<unsigned int> &
    n_iterations() const = 0;
  };
} // namespace springfit

#endif
