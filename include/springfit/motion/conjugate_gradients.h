#ifndef springfit_motion_conjugate_gradients_h
#define springfit_motion_conjugate_gradients_h

#include <Eigen/Core>

#include <functional>

namespace springfit
{
  /** Sets its second argument to a symmetric matrix times the first. */
  using MatrixProduct =
    std::function<void(const Eigen::MatrixXd &u, Eigen::MatrixXd &product)>;

  /** How conjugate gradients ended. */
  struct ConjugateGradients
  {
    unsigned int n_iterations = 0;

    /** Whether the residual's norm is what was asked for. */
    bool has_converged = false;

    /** The last residual relative to the first. */
    double reduction = 1.;
  };

  /**
   * The preconditioned conjugate gradient method (Saad 2003, Iterative methods
   * for sparse linear systems, algorithm 9.1) on vectors that are matrices of
   * the same size.
   *
   * @param matrix positive definite; where it turns out not to be the method
   * ends without having converged
   * @param preconditioner positive definite
   * @param norm of the residual at which it ends
   * @param solution at first a guess
   * @param residual of the guess, at last of the solution
   */
  ConjugateGradients
  conjugate_gradients(const MatrixProduct &matrix,
                      const MatrixProduct &preconditioner,
                      double norm,
                      unsigned int most_iterations,
                      Eigen::MatrixXd &solution,
                      Eigen::MatrixXd &residual);
} // namespace springfit

#endif
