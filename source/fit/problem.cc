#include <springfit/fit/problem.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/volume.h>

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
    const Eigen::MatrixXd &B = problem.gradients;
    Eigen::MatrixXd E        = residual(problem, model.k);
    for (const auto &[a, b, stiffness] : model.couplings)
      {
        const Eigen::MatrixXd term =
          stiffness * B.col(a) * B.col(b).transpose();
        E -= term + term.transpose();
      }
    if (model.angle_stiffness.size() > 0)
      {
        const Eigen::MatrixXd A =
          angle_gradients(problem.points, cell_angles(problem.kind));
        E -= A * model.angle_stiffness.asDiagonal() * A.transpose();
      }
    if (model.volume_stiffness)
      {
        const Eigen::VectorXd g = volume_gradient(problem.points, problem.kind);
        E -= *model.volume_stiffness * g * g.transpose();
      }
    return E;
  }
} // namespace springfit
