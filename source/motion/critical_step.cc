#include <springfit/motion/critical_step.h>
#include <springfit/motion/largest_mode.h>

#include <cmath>

namespace springfit
{
  CriticalStep
  critical_step(const MovingBody &body, const Eigen::MatrixXd &displacement)
  {
    // With a tenth of a per cent Lanczos' method may stop at the second of two
    // frequencies that are near each other.
    constexpr double tolerance = 1e-5;
    const int dim              = displacement.rows();
    const LargestMode fastest  = largest_mode(
      dim,
      [&](const Eigen::MatrixXd &u, Eigen::MatrixXd &product) {
        product = body.largest_load_stiffness * u;
        body.elastic->add_tangent_product(displacement, u, product);
      },
      body.mass,
      body.held,
      tolerance);
    RayleighDamping damping = body.damping;
    if (are_there(body.dampers))
      damping.mass_factor +=
        largest_mode(
          dim,
          [&](const Eigen::MatrixXd &u, Eigen::MatrixXd &product) {
            product = damper_product(body.dampers, displacement, u);
          },
          body.mass,
          body.held,
          tolerance)
          .square;
    return {stable_step(damping, std::sqrt(fastest.square)), fastest.shape};
  }
} // namespace springfit
