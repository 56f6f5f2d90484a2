#include <springfit/reference/membrane_state.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace springfit
{
  std::optional<MembraneState>
  membrane_state(const PlaneLaw &law, const Eigen::Matrix<double, 3, 2> &F)
  {
    // F = Q U with an orthonormal basis Q of the tangent plane.
    constexpr double rounding = 1e-14;
    const double length       = F.col(0).norm();
    const Eigen::Vector3d a   = F.col(0) / length;
    Eigen::Vector3d b         = F.col(1) - a * a.dot(F.col(1));
    if (!(length > rounding * F.col(1).norm() &&
          b.norm() > rounding * F.col(1).norm()))
      return {};
    b.normalize();
    Eigen::Matrix<double, 3, 2> Q;
    Q << a, b;
    const Eigen::Vector3d n = a.cross(b);
    const Eigen::Matrix2d U = Q.transpose() * F;

    const auto plane = law(U);
    if (!plane)
      return {};
    MembraneState state;
    state.energy            = plane->energy;
    state.stress            = Q * plane->stress;
    const Eigen::Matrix2d S = U.inverse() * plane->stress;
    for (int k = 0; k < 2; ++k)
      for (int l = 0; l < 2; ++l)
        state.tangent.block<3, 3>(3 * k, 3 * l) =
          Q * plane->tangent.block<2, 2>(2 * k, 2 * l) * Q.transpose() +
          S(k, l) * n * n.transpose();
    return state;
  }
} // namespace springfit
