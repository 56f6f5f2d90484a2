#include <springfit/fit/problem.h>
#include <springfit/springs/gradients.h>

namespace springfit
{
  FitProblem
  make_fit_problem(const Eigen::MatrixXd &points,
                   const CellKind kind,
                   const Eigen::MatrixXd &stiffness)
  {
    const auto &springs = node_pairs(kind);
    return {points, springs, length_gradients(points, springs), stiffness};
  }


  Eigen::MatrixXd
  residual(const FitProblem &problem, const Eigen::VectorXd &k)
  {
    const Eigen::MatrixXd &B = problem.gradients;
    return problem.stiffness - B * k.asDiagonal() * B.transpose();
  }
} // namespace springfit
