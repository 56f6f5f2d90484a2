#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/gelder.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/volume.h>

namespace springfit
{
  Eigen::VectorXd
  fit_gelder(const Eigen::MatrixXd &points,
             const CellKind kind,
             const IsotropicMaterial &material)
  {
    const auto &pairs = node_pairs(kind);
    const double E_V =
      material.youngs_modulus * material.thickness * volume(points, kind);
    Eigen::VectorXd k(pairs.size());
    for (Eigen::Index s = 0; s < k.size(); ++s)
      k[s] =
        E_V / (points.col(pairs[s][1]) - points.col(pairs[s][0])).squaredNorm();
    return k;
  }


  FittedCell
  fit_gelder(const FitProblem &problem, const FitOptions &)
  {
    return {coupled_model(
      problem, fit_gelder(problem.points, problem.kind, problem.material), {})};
  }
} // namespace springfit
