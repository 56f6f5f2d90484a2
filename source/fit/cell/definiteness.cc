#include <springfit/fit/cell/definiteness.h>
#include <springfit/fit/cell/spectral.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/Eigenvalues>

namespace springfit
{
  namespace
  {
    /** Below it an eigenvalue is negative, above it may be rounding. */
    constexpr double zero_eigenvalue = -1e-10;
  } // namespace

  double
  smallest_eigenvalue(const FitProblem &problem, const CellModel &model)
  {
    const Eigen::MatrixXd Q = deformation_basis(problem.points);
    const Eigen::MatrixXd K = problem.stiffness - residual(problem, model);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      Q.transpose() * K * Q, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()[0] / spectral_norm(problem.stiffness);
  }

  bool
  is_definite(const double smallest_eigenvalue)
  {
    return smallest_eigenvalue >= zero_eigenvalue;
  }

  CellModel
  furthest_definite(const FitProblem &problem,
                    const CellModel &safe,
                    const CellModel &wanted)
  {
    double inside = 0., outside = 1.;
    while (outside - inside > 1e-3)
      {
        const double middle     = 0.5 * (inside + outside);
        const CellModel between = springfit::between(safe, wanted, middle);
        (is_definite(smallest_eigenvalue(problem, between)) ? inside
                                                            : outside) = middle;
      }
    return between(safe, wanted, 0.9 * inside);
  }
} // namespace springfit
