#include <springfit/motion/moving_body.h>

namespace springfit
{
  double
  kinetic_energy(const MovingBody &body, const MotionState &state)
  {
    return 0.5 * state.velocity.colwise().squaredNorm() * body.mass;
  }


  double
  elastic_energy(const MovingBody &body, const MotionState &state)
  {
    return body.elastic->energy(state.displacement);
  }


  Eigen::VectorXd
  momentum(const MovingBody &body, const MotionState &state)
  {
    return state.velocity * body.mass;
  }


  Eigen::MatrixXd
  driving_forces(const MovingBody &body, const MotionState &state)
  {
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(state.displacement.rows(),
                                                   state.displacement.cols());
    body.elastic->add_forces(state.displacement, forces);
    if (body.loads)
      body.loads(state, forces);
    return forces;
  }


  void
  copy_held(const MovingBody &body,
            const Eigen::MatrixXd &others,
            Eigen::MatrixXd &values)
  {
    for (std::size_t i = 0; i < body.held.size(); ++i)
      if (body.held[i])
        values.reshaped()[i] = others.reshaped()[i];
  }


  Eigen::MatrixXd
  with_supports(const MovingBody &body,
                const double time,
                const Eigen::MatrixXd &displacement)
  {
    Eigen::MatrixXd result = displacement;
    if (!body.support)
      return result;
    Eigen::MatrixXd there = displacement;
    body.support(time, there);
    copy_held(body, there, result);
    return result;
  }
} // namespace springfit
