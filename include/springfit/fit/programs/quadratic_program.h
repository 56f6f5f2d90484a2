#ifndef springfit_fit_programs_quadratic_program_h
#define springfit_fit_programs_quadratic_program_h

#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  // Minimise x^T G x / 2 - g^T x, with x_s >= 0 where nonnegative[s]: convex
  // quadratic programs with bounds, of any size. G is n x n, symmetric (both
  // triangles are given) and positive semidefinite with a positive diagonal.
  // nonnegative_least_squares.h is for those of a cell.

  /**
   * The minimiser, by Cholesky factorisations; without bounds one is enough.
   * The bounds that hold are found by the primal-dual active set method
   * (Hintermueller, Ito and Kunisch 2002), so that a variable is zero or
   * clearly not; where the sets do not settle, Ipopt finds them.
   *
   * Variables are scaled to a diagonal of one first. Where G is singular the
   * minimiser that is smallest in these units is taken (by a ridge of 1e-10).
   *
   * Not to be called from several threads: Ipopt's MUMPS is not thread-safe.
   *
   * @throws RunError when G or g is not finite, an entry of G's diagonal is not
   * positive, or the point found does not meet the conditions of optimality.
   */
  Eigen::VectorXd
  minimise_quadratic(const Eigen::SparseMatrix<double> &G,
                     const Eigen::VectorXd &g,
                     const std::vector<bool> &nonnegative);

  /** A dense G is scaled in place; besides it there are only its factors. */
  Eigen::VectorXd
  minimise_quadratic(Eigen::MatrixXd G,
                     const Eigen::VectorXd &g,
                     const std::vector<bool> &nonnegative);
} // namespace springfit

#endif
