#include <springfit/fit/cell/certificate.h>
#include <springfit/fit/cell/frobenius.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace springfit
{
  namespace
  {
    /** b_s^T M b_s where it should be zero, or not positive. */
    Eigen::VectorXd
    violations(const SpectralProblem &problem, const Eigen::MatrixXd &M)
    {
      Eigen::VectorXd v  = tangent_products(problem.B, M);
      const auto bounded = Eigen::seqN(0, problem.n_nonnegative);
      v(bounded)         = v(bounded).cwiseMax(0.).eval();
      return v.cwiseAbs();
    }

    /**
     * Above the magnitudes of the constants of which B diag(k) B^T is at most
     * as large as @p size, in the spectral norm. Infinite where nothing bounds
     * them.
     */
    Eigen::VectorXd
    largest_constants(const SpectralProblem &problem, const double size)
    {
      const Eigen::MatrixXd &B     = problem.B;
      const Eigen::VectorXd square = B.colwise().squaredNorm();
      // Terms that are all >= 0 do not cancel.
      if (problem.n_nonnegative == B.cols())
        return (size / square.array()).matrix();
      // ||B diag(k) B^T||_F^2 = (d k)^T G (d k), G of unit diagonal.
      const Eigen::MatrixXd gram = square.cwiseInverse().asDiagonal() *
                                   tangent_gram(B) *
                                   square.cwiseInverse().asDiagonal();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
      constexpr double rounding = 1e-13;
      const Eigen::ArrayXd squares =
        (eigen.eigenvectors().array().square().rowwise() /
         (eigen.eigenvalues().array() - rounding).max(0.).transpose())
          .rowwise()
          .sum();
      return (size * std::sqrt(double(B.rows())) * squares.sqrt() /
              square.array())
        .matrix();
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

    Eigen::MatrixXd
    positive_part(const Eigen::MatrixXd &symmetric)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
      return eigen.eigenvectors() *
             eigen.eigenvalues().cwiseMax(0.).asDiagonal() *
             eigen.eigenvectors().transpose();
    }
  } // namespace

  double
  dual_bound(const SpectralProblem &problem,
             const SpectralSolution &multipliers,
             const double value)
  {
    const bool has_least = problem.least.size() > 0;
    if (!multipliers.multiplier.allFinite() ||
        (has_least && !multipliers.multiplier_of_least.allFinite()))
      return 0.;
    const Eigen::MatrixXd Y3 =
      has_least ? positive_part(multipliers.multiplier_of_least)
                : Eigen::MatrixXd::Zero(problem.R.rows(), problem.R.cols());
    Eigen::MatrixXd M = multipliers.multiplier;
    // Where little of M is feasible, rounding errors of the projection must
    // not be taken for a bound.
    const double rounding = 1e-13 * (M.norm() + Y3.norm());
    const Eigen::VectorXd largest =
      largest_constants(problem, spectral_norm(problem.R) + value);

    double best = 0.; // A norm is at least zero, whatever M says.
    // What rounding leaves of a projection another one takes away.
    for (unsigned int projection = 0; projection < 3; ++projection)
      {
        // The optimality conditions of a fit are the constraints on what it
        // leaves: b_s^T (M - B diag(c) B^T) b_s = 0, or <= 0 with c >= 0.
        const Eigen::VectorXd c =
          fit_frobenius(problem.B, M + Y3, problem.n_nonnegative);
        M -= problem.B * c.asDiagonal() * problem.B.transpose();
        const Eigen::VectorXd v = violations(problem, M + Y3);
        double product          = problem.R.cwiseProduct(M).sum() - rounding;
        if (has_least)
          product += problem.least.cwiseProduct(Y3).sum();
        for (Eigen::Index s = 0; s < v.size(); ++s)
          if (v[s] > 0.)
            product -= v[s] * largest[s];
        const double size = nuclear_norm(M);
        if (size > 0. && product / size > best)
          best = product / size;
      }
    return best;
  }


  double
  duality_gap(const SpectralProblem &problem, const SpectralSolution &solution)
  {
    const double value = spectral_norm(residual(problem, solution.k));
    return value - dual_bound(problem, solution, value);
  }
} // namespace springfit
