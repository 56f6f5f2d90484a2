#include <springfit/fit/cell/coupled_cell.h>
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

    double
    smallest_eigenvalue(const FitProblem &problem, const Eigen::MatrixXd &K)
    {
      const Eigen::MatrixXd Q = deformation_basis(problem.points);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        Q.transpose() * K * Q, Eigen::EigenvaluesOnly);
      return eigen.eigenvalues()[0] / spectral_norm(problem.stiffness);
    }
  } // namespace

  double
  smallest_eigenvalue(const FitProblem &problem, const CellModel &model)
  {
    return smallest_eigenvalue(problem,
                               problem.stiffness - residual(problem, model));
  }

  bool
  is_definite(const double smallest_eigenvalue)
  {
    return smallest_eigenvalue >= zero_eigenvalue;
  }

  double
  floor_of_eigenvalues(const FitProblem &problem)
  {
    constexpr double share = 0.03;
    return share * smallest_eigenvalue(problem, problem.stiffness);
  }

  CellModel
  equal_springs(const FitProblem &problem)
  {
    const Eigen::MatrixXd one =
      problem.gradients * problem.gradients.transpose();
    const double k =
      one.cwiseProduct(problem.stiffness).sum() / one.squaredNorm();
    return coupled_model(problem,
                         Eigen::VectorXd::Constant(problem.springs.size(), k),
                         {});
  }

  CellModel
  without_mechanisms(const FitProblem &problem, const CellModel &model)
  {
    const double floor = floor_of_eigenvalues(problem);
    const double found = smallest_eigenvalue(problem, model);
    if (!is_definite(found) || found >= floor)
      return model;

    const CellModel equal = equal_springs(problem);
    // What is stiff enough is a convex set.
    double soft = 0., stiff = 1.;
    while (stiff - soft > 1e-3 * stiff)
      {
        const double middle     = 0.5 * (soft + stiff);
        const CellModel between = springfit::between(model, equal, middle);
        (smallest_eigenvalue(problem, between) < floor ? soft : stiff) = middle;
      }
    return between(model, equal, stiff);
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
