#include <springfit/motion/moving_body.h>

#include <cmath>

namespace springfit
{
  Eigen::MatrixXd
  mass_product(const MovingBody &body, const Eigen::MatrixXd &u)
  {
    if (body.consistent_mass.nonZeros() > 0)
      return u * body.consistent_mass;
    return u * body.mass.asDiagonal();
  }


  double
  kinetic_energy(const MovingBody &body, const MotionState &state)
  {
    return 0.5 * state.velocity.cwiseProduct(mass_product(body, state.velocity))
                   .sum();
  }


  double
  elastic_energy(const MovingBody &body, const MotionState &state)
  {
    return body.elastic->energy(state.displacement);
  }


  Eigen::VectorXd
  momentum(const MovingBody &body, const MotionState &state)
  {
    return mass_product(body, state.velocity).rowwise().sum();
  }


  double
  norm_of_free(const MovingBody &body, const Eigen::MatrixXd &forces)
  {
    double square = 0.;
    for (std::size_t i = 0; i < body.held.size(); ++i)
      if (!body.held[i])
        square += forces.reshaped()[i] * forces.reshaped()[i];
    return std::sqrt(square);
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


  SupportMotion
  motion_of_supports(const MovingBody &body,
                     const double time,
                     const double interval)
  {
    const Eigen::MatrixXd rest =
      Eigen::MatrixXd::Zero(body.held.size() / body.mass.size(),
                            body.mass.size());
    const auto at = [&](const double t) {
      return with_supports(body, t, rest);
    };
    const Eigen::MatrixXd before = at(time - interval),
                          after  = at(time + interval);
    return {(after - before) / (2. * interval),
            (after - 2. * at(time) + before) / (interval * interval)};
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
