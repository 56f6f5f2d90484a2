#include <springfit/fit/cell/certificate.h>
#include <springfit/fit/cell/frobenius.h>

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace springfit
{
  namespace
  {
    Eigen::MatrixXd
    dual_feasible(const SpectralProblem &problem, const Eigen::MatrixXd &M)
    {
      // The optimality conditions of a fit of M are the constraints on what
      // it leaves: b_s^T (M - B diag(c) B^T) b_s = 0, or <= 0 with c >= 0.
      const Eigen::VectorXd c =
        fit_frobenius(problem.B, M, problem.n_nonnegative);
      return M - problem.B * c.asDiagonal() * problem.B.transpose();
    }

    double
    nuclear_norm(const Eigen::MatrixXd &symmetric)
    {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
               symmetric, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseAbs()
        .sum();
    }
  } // namespace

  double
  dual_bound(const SpectralProblem &problem, const Eigen::MatrixXd &M)
  {
    if (!M.allFinite())
      return 0.;
    const Eigen::MatrixXd feasible = dual_feasible(problem, M);
    const double size              = nuclear_norm(feasible);
    // Where little of M is feasible, rounding errors of the projection must
    // not be taken for a bound.
    const double rounding = 1e-13 * M.norm();
    const double product  = problem.R.cwiseProduct(feasible).sum() - rounding;
    // A norm is at least zero, whatever M says.
    return size > 0. ? std::max(0., product / size) : 0.;
  }


  double
  duality_gap(const SpectralProblem &problem, const SpectralSolution &solution)
  {
    return spectral_norm(residual(problem, solution.k)) -
           dual_bound(problem, solution.multiplier);
  }
} // namespace springfit
