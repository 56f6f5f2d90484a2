#include <springfit/fit/cell/golec.h>
#include <springfit/fit/cell/lloyd.h>
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
  golec_assumptions(const IsotropicMaterial &material)
  {
    return material.poissons_ratio < 0.25 - 1e-12
             ? std::vector<std::string>{"Poisson's ratio 1/4 or more, so that "
                                        "no volume spring is negative"}
             : std::vector<std::string>{};
  }
} // namespace springfit
