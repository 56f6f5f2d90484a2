#ifndef springfit_fit_programs_ipopt_quadratic_h
#define springfit_fit_programs_ipopt_quadratic_h

#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /**
   * Minimise x^T G x / 2 - g^T x, with x_s >= 0 where @p nonnegative says so,
   * by Ipopt's interior point method (Waechter and Biegler 2006) in Mehrotra's
   * variant for convex quadratic programs.
   *
   * Ipopt's status is not a judgement: the caller must check the point.
   *
   * @param G symmetric positive definite, n x n, both triangles
   * @param g n
   * @param start n; moved into the bounds' interior
   *
   * @throws RunError when Ipopt ends without a finite point.
   */
  Eigen::VectorXd
  minimise_by_ipopt(const Eigen::SparseMatrix<double> &G,
                    const Eigen::VectorXd &g,
                    const std::vector<bool> &nonnegative,
                    const Eigen::VectorXd &start);
} // namespace springfit

#endif
