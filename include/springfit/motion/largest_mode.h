#ifndef springfit_motion_largest_mode_h
#define springfit_motion_largest_mode_h

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace springfit
{
  /** The motion of a body with the highest frequency. */
  struct LargestMode
  {
    /**
     * The largest eigenvalue of M^-1 K, (rad/s)^2: that of the Krylov space
     * plus the residual's norm, so that some eigenvalue lies between @p lowest
     * and this. 0 when nothing moves or nothing resists.
     */
    double square = 0.;

    /** The eigenvalue of the Krylov space, which is never too large. */
    double lowest = 0.;

    /** The motion, dim x n_nodes, of norm 1. */
    Eigen::MatrixXd shape;

    unsigned int n_products = 0; // with K
  };

  /** Sets its second argument to K times the first; both dim x n_nodes. */
  using StiffnessProduct =
    std::function<void(const Eigen::MatrixXd &u, Eigen::MatrixXd &product)>;

  /**
   * The largest eigenvalue of M^-1 K by Lanczos' method on
   * M^(-1/2) K M^(-1/2) with all vectors orthogonalised (Parlett 1998, The
   * symmetric eigenvalue problem, chapter 13), from a fixed start.
   *
   * @param stiffness symmetric, N/m; negative eigenvalues are passed over
   * @param mass of each node, kg, positive
   * @param held a flag per unknown, dim * v + d: it does not move
   * @param tolerance for the residual relative to the eigenvalue
   */
  LargestMode
  largest_mode(int dim,
               const StiffnessProduct &stiffness,
               const Eigen::VectorXd &mass,
               const std::vector<bool> &held,
               double tolerance = 1e-3);
} // namespace springfit

#endif
