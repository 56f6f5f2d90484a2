#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/QR>

#include <cmath>
#include <vector>

namespace springfit
{
  CellModel
  fit_coupled_cell(const FitProblem &problem)
  {
    // On the deformations B^T has full column rank: e = A a, and
    // A^+T R A^+ is what C must be.
    const Eigen::MatrixXd Q = deformation_basis(problem.points);
    const Eigen::MatrixXd A = problem.gradients.transpose() * Q;
    const Eigen::MatrixXd A_inverse =
      A.completeOrthogonalDecomposition().pseudoInverse();
    const Eigen::MatrixXd C =
      A_inverse.transpose() * Q.transpose() * problem.stiffness * Q * A_inverse;

    std::vector<LengthCoupling> couplings;
    // Symmetry makes many of them zero.
    const double rounding = 1e-13 * C.cwiseAbs().maxCoeff();
    for (unsigned int a = 0; a < C.cols(); ++a)
      for (unsigned int b = a + 1; b < C.cols(); ++b)
        if (std::abs(C(a, b)) > rounding)
          couplings.push_back({a, b, C(a, b)});
    return coupled_model(problem, C.diagonal(), couplings);
  }

  CellModel
  coupled_model(const FitProblem &problem,
                const Eigen::VectorXd &k,
                const std::vector<LengthCoupling> &couplings)
  {
    CellModel model{
      {lengths_at_rest(problem.points, problem.springs, k, problem.law)}};
    if (!couplings.empty())
      model.families.push_back(couplings_at_rest(
        problem.points, problem.springs, couplings, problem.law));
    return model;
  }
} // namespace springfit
