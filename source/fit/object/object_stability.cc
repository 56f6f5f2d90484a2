#include <springfit/fit/object/free_body.h>
#include <springfit/fit/object/object_stability.h>

namespace springfit
{
  double
  share_to_instability(const ObjectProblem &problem,
                       const Eigen::VectorXd &stable,
                       const Eigen::VectorXd &unstable)
  {
    const auto K_stable   = fitted_stiffness(problem, stable);
    const auto K_unstable = fitted_stiffness(problem, unstable);
    double inside = 0., outside = 1.;
    while (outside - inside > 1e-3)
      {
        const double t = 0.5 * (inside + outside);
        const FreeBody body((1. - t) * K_stable + t * K_unstable,
                            problem.nodes);
        (body.n_unstable() == 0 ? inside : outside) = t;
      }
    return inside;
  }
} // namespace springfit
