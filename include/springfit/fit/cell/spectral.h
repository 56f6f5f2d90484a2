#ifndef springfit_fit_cell_spectral_h
#define springfit_fit_cell_spectral_h

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * min_k ||E(k)||_2, E(k) = R - B diag(k) B^T, in its epigraph form: the
   * smallest t for which A1 = t I - E(k) and A2 = t I + E(k) are positive
   * semidefinite, optionally with some k >= 0, and with A3 = B diag(k) B^T - F
   * positive semidefinite.
   *
   * R and B are projected on the cell's deformations, where they lose nothing,
   * and R is scaled to ||R||_2 = 1, so that t and every gap is relative.
   */
  struct SpectralProblem
  {
    /** n x n, n = 3, 5, 6, 18 */
    Eigen::MatrixXd R;

    /** n x n_springs */
    Eigen::MatrixXd B;

    /** ||R||_2 before scaling, N/m: multiply k by it. */
    double scale;

    /** How many of the k, from the first on, must not be negative. */
    Eigen::Index n_nonnegative;

    /** F, n x n, relative to ||R||_2; empty where A3 is not asked for. */
    Eigen::MatrixXd least = {};
  };

  /**
   * @param points dim x n_nodes, m
   * @param B (dim * n_nodes) x n_terms
   * @param R (dim * n_nodes) x (dim * n_nodes), N/m
   * @param least F, as R, N/m; empty for none
   */
  SpectralProblem
  make_spectral_problem(const Eigen::MatrixXd &points,
                        const Eigen::MatrixXd &B,
                        const Eigen::MatrixXd &R,
                        Eigen::Index n_nonnegative,
                        const Eigen::MatrixXd &least = {});

  /**
   * A point (k, t) strictly inside: Frobenius' k, moved towards equal springs
   * as far as the bounds ask for, and t above ||E(k)||_2.
   *
   * @throws RunError when there is none: F is more than equal springs can be
   */
  Eigen::VectorXd
  interior_point(const SpectralProblem &problem);

  /** E(k) */
  Eigen::MatrixXd
  residual(const SpectralProblem &problem,
           const Eigen::Ref<const Eigen::VectorXd> &k);

  /** ||E(k)||_2 from the eigenvalues. */
  double
  spectral_norm(const Eigen::MatrixXd &symmetric);

  /** What an engine returns. */
  struct SpectralSolution
  {
    /** n_springs, relative to the problem's scale */
    Eigen::VectorXd k;

    /**
     * Y1 - Y2, n x n, of the multipliers of A1 and A2. It is only ever used
     * through certificate.h, which makes a valid bound of anything.
     */
    Eigen::MatrixXd multiplier;

    /** Y3, n x n, of A3; empty without one. As good as the other. */
    Eigen::MatrixXd multiplier_of_least = {};
  };


  // As a smooth convex program: the pivots d_i of A1 = L D L^T and the others
  // are concave functions of x = (k, t) inside the cone, and positive exactly
  // there (Fletcher 1985; Benson and Vanderbei 2003). The sum of their
  // logarithms is log det A1 + log det A2, so a solver with logarithmic
  // barriers follows the central path of the semidefinite program.

  /** How many there are: n of each A. */
  Eigen::Index
  n_pivots(const SpectralProblem &problem);

  /**
   * All pivots, those of A1 first.
   *
   * @return nothing when an A is not positive definite
   */
  std::optional<Eigen::VectorXd>
  pivots(const SpectralProblem &problem, const Eigen::VectorXd &x);

  /** Their first derivatives, n_pivots x (n_springs + 1); nothing as above. */
  std::optional<Eigen::MatrixXd>
  pivot_jacobian(const SpectralProblem &problem, const Eigen::VectorXd &x);

  /**
   * The second derivatives of sum_i weights_i d_i, symmetric
   * (n_springs + 1) x (n_springs + 1), all entries set; nothing as above.
   */
  std::optional<Eigen::MatrixXd>
  pivot_hessian(const SpectralProblem &problem,
                const Eigen::VectorXd &x,
                const Eigen::VectorXd &weights);

  /**
   * The solution k of x = (k, t) with the multipliers Y = L^-T diag(y) L^-1 of
   * each cone from those of its pivots; nothing as above.
   */
  std::optional<SpectralSolution>
  pivot_solution(const SpectralProblem &problem,
                 const Eigen::VectorXd &x,
                 const Eigen::VectorXd &y);
} // namespace springfit

#endif
