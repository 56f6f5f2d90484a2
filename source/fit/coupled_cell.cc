#include <springfit/fit/coupled_cell.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/QR>

#include <cmath>

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

    CellModel model{C.diagonal()};
    // Symmetry makes many of them zero.
    const double rounding = 1e-13 * C.cwiseAbs().maxCoeff();
    for (unsigned int a = 0; a < C.cols(); ++a)
      for (unsigned int b = a + 1; b < C.cols(); ++b)
        if (std::abs(C(a, b)) > rounding)
          model.couplings.push_back({a, b, C(a, b)});
    return model;
  }
} // namespace springfit
