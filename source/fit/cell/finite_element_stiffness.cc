#include <springfit/fit/cell/finite_element_stiffness.h>
#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/network.h>

namespace springfit
{
  Eigen::MatrixXd
  finite_element_stiffness(const Eigen::MatrixXd &points,
                           const CellKind kind,
                           const IsotropicMaterial &material)
  {
    const auto problem = make_fit_problem(points, kind, {}, material);
    const auto exact =
      fit_stable_neo_hookean_points(problem, VolumeLaw::quadratic);
    return tangent(exact.families, points);
  }
} // namespace springfit
