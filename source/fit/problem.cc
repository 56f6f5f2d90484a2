#include <springfit/fit/problem.h>
#include <springfit/springs/gradients.h>

namespace springfit
{
  FitProblem
  make_fit_problem(const Eigen::MatrixXd &points,
                   const CellKind kind,
                   const Eigen::MatrixXd &stiffness,
                   const IsotropicMaterial &material)
  {
    const auto &springs = node_pairs(kind);
    return {points,
            springs,
            length_gradients(points, springs),
            stiffness,
            kind,
            material};
  }


  Eigen::MatrixXd
  residual(const FitProblem &problem, const Eigen::VectorXd &k)
  {
    const Eigen::MatrixXd &B = problem.gradients;
    return problem.stiffness - B * k.asDiagonal() * B.transpose();
  }


  Eigen::MatrixXd
  residual(const FitProblem &problem, const CellModel &model)
  {
    return problem.stiffness -
           Eigen::MatrixXd(tangent(model.families, problem.points));
  }
} // namespace springfit
