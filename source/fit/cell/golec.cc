#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/golec.h>
#include <springfit/fit/cell/lloyd.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/volume.h>

namespace springfit
{
  Eigen::VectorXd
  fit_golec(const Eigen::MatrixXd &points, const IsotropicMaterial &material)
  {
    // At Poisson's ratio 1/4, E = 5/2 G.
    return fit_lloyd(points,
                     CellKind::tetrahedron,
                     {2.5 * shear_modulus(material), 0.25, 1.});
  }


  double
  golec_volume_stiffness(const Eigen::MatrixXd &points,
                         const IsotropicMaterial &material)
  {
    const double nu     = material.poissons_ratio;
    const double mu     = shear_modulus(material);
    const double lambda = 2. * mu * nu / (1. - 2. * nu);
    return (lambda - mu) / volume(points, CellKind::tetrahedron);
  }


  std::vector<std::string>
  golec_assumptions(const Eigen::MatrixXd &,
                    const CellKind,
                    const IsotropicMaterial &material)
  {
    return material.poissons_ratio < 0.25 - 1e-12
             ? std::vector<std::string>{"Poisson's ratio 1/4 or more, so that "
                                        "no volume spring is negative"}
             : std::vector<std::string>{};
  }


  FittedCell
  fit_golec(const FitProblem &problem, const FitOptions &)
  {
    CellModel model =
      coupled_model(problem, fit_golec(problem.points, problem.material), {});
    model.families.push_back(
      volume_at_rest(problem.points,
                     problem.kind,
                     golec_volume_stiffness(problem.points, problem.material)));
    return {model};
  }
} // namespace springfit
