#ifndef springfit_motion_iterative_step_system_h
#define springfit_motion_iterative_step_system_h

#include <springfit/motion/conjugate_gradients.h>
#include <springfit/motion/direct_step_system.h>
#include <springfit/motion/step_preconditioner.h>
#include <springfit/motion/step_system.h>
#include <springfit/springs/tangent_operator.h>

#include <Eigen/Core>

#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace springfit
{
  /** How long a preconditioner serves. */
  enum class PreconditionerLife
  {
    /** For one linearisation. */
    short_one,

    /**
     * It is built at rest, and anew at the present state when it serves much
     * worse than in the beginning.
     */
    long_one
  };


  /**
   * By preconditioned conjugate gradients with products that need no matrix,
   * from a guess that solutions before suggest.
   */
  class IterativeStepSystem : public StepSystem
  {
  public:
    /**
     * @param body must outlive the object
     * @param tolerance for the residual relative to the forces
     */
    IterativeStepSystem(int dim,
                        const MovingBody &body,
                        std::unique_ptr<StepPreconditioner> preconditioner,
                        PreconditionerLife life = PreconditionerLife::long_one,
                        double tolerance        = 1e-6,
                        WhereIndefinite where   = WhereIndefinite::factors);

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
    /** Sets @p product to the step's matrix times @p u, 0 where held. */
    void
    multiply(const Eigen::MatrixXd &u, Eigen::MatrixXd &product) const;

    /** Build the preconditioner where there is none that suits. */
    void
    prepare(const StepFactors &factors);

    /**
     * What the solutions before suggest; takes what the matrix makes of it away
     * from @p residual.
     */
    Eigen::MatrixXd
    guess(Eigen::MatrixXd &residual) const;

    /**
     * Sets the scales of touched nodes: with S = (I + B / a)^(-1/2) on both
     * sides of the preconditioner, of a node's loads' stiffness B and its
     * diagonal a, it counts what loads stiffen.
     */
    void
    set_scales();

    void
    scale_touched(Eigen::MatrixXd &values) const;

    void
    precondition(const Eigen::MatrixXd &forces, Eigen::MatrixXd &motion) const;

    /** Whether the preconditioner serves as in the beginning. */
    void
    judge(const ConjugateGradients &result);

    void
    build_preconditioner(const MotionState &state);

    /** After so many a new preconditioner is cheaper. */
    unsigned int
    n_iterations_to_try() const;

    /**
     * By conjugate gradients with the present stiffness, from a @p solution
     * that leaves a @p residual, to the tolerance times @p norm; or nothing.
     */
    std::optional<Eigen::MatrixXd>
    solve_iteratively(double norm,
                      Eigen::MatrixXd solution,
                      Eigen::MatrixXd residual);

    /** The same from a guess. */
    std::optional<Eigen::MatrixXd>
    solve_iteratively(const Eigen::MatrixXd &forces);

    bool
    is_convex() const;

    void
    take_convex_tangent();

    Eigen::MatrixXd
    solve_directly(const Eigen::MatrixXd &forces);

    const int dim_;
    const MovingBody &body_;
    const std::unique_ptr<StepPreconditioner> preconditioner_;
    const PreconditionerLife life_;
    const double tolerance_;

    const std::unique_ptr<TangentOperator> tangent_;
    const WhereIndefinite where_indefinite_;
    std::unique_ptr<TangentOperator> convex_tangent_; // none unless wanted
    TangentOperator *stiffness_;                      // one of the two

    // For how many more linearisations it is the convex one.
    unsigned int n_convex_ = 0;

    MotionState state_, state_of_loads_;
    Eigen::MatrixXd load_blocks_;       // see MovingBody::load_stiffness
    std::vector<Eigen::Index> touched_; // nodes that it is not 0 of

    // Of each of them, dim x dim, see set_scales(); none where not needed.
    std::vector<Eigen::MatrixXd> scales_;

    const Eigen::VectorXd mass_of_unknowns_;   // kg, dim * v + d
    std::unique_ptr<DirectStepSystem> direct_; // none before it is wanted

    const std::vector<Eigen::Index> held_; // unknowns, see MovingBody

    StepFactors factors_{};
    std::deque<Eigen::MatrixXd> solutions_; // the last one first
    std::vector<unsigned int> n_iterations_;

    // Iterations per decade of the residual with a new preconditioner; 0 before
    // there are any.
    double first_effort_ = 0.;
    bool is_outworn_     = false;

    // Whether the preconditioner is one: the matrix may have none.
    bool is_positive_ = false;
  };
} // namespace springfit

#endif
