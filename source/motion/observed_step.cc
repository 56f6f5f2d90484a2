#include <springfit/motion/integrators.h>
#include <springfit/motion/observed_step.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace springfit
{
  namespace
  {
    constexpr double without_bounds = 1e3;

    /** Of free unknowns alone. */
    Eigen::MatrixXd
    random_motion(const MovingBody &body, const int dim)
    {
      std::mt19937 generator(1);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      Eigen::MatrixXd motion(dim, body.mass.size());
      for (Eigen::Index i = 0; i < motion.size(); ++i)
        motion.data()[i] = body.held[i] ? 0. : uniform(generator);
      return motion;
    }
  } // namespace


  ObservedMotion
  observe(const MovingBody &body,
          StepSystem &system,
          const int dim,
          const double step,
          const std::uint64_t n_steps,
          const double size)
  {
    const Eigen::MatrixXd motion = random_motion(body, dim);
    MotionState state;
    state.displacement   = 1e-6 * size * motion;
    state.velocity       = 0. * motion;
    state.acceleration   = 0. * motion;
    const double at_rest = body.elastic->energy(0. * motion);

    const std::uint64_t tenth = std::max<std::uint64_t>(1, n_steps / 10);
    double early = 0., first = 0., last = 0.;
    for (std::uint64_t i = 0; i < n_steps; ++i)
      {
        symplectic_euler_step(body, system, step, state);
        const double speed = norm_of_free(body, state.velocity);
        if (i < 10)
          early = std::max(early, speed);
        if (!(speed < without_bounds * early))
          return {true, 0.};
        const double elastic = body.elastic->energy(state.displacement);
        if (!std::isfinite(elastic))
          return {true, 0.};
        const double energy = kinetic_energy(body, state) + elastic - at_rest;
        if (i < tenth)
          first += energy / tenth;
        if (i >= n_steps - tenth)
          last += energy / tenth;
      }
    return {false, first > 0. ? (last - first) / first : 0.};
  }


  double
  observed_step(const MovingBody &body,
                StepSystem &system,
                const int dim,
                const double guess,
                const std::uint64_t n_steps,
                const double width,
                const double size)
  {
    const auto grows = [&](const double step) {
      return observe(body, system, dim, step, n_steps, size).grows;
    };
    double stable = 0.5 * guess, unstable = 2. * guess;
    if (grows(stable))
      return 0.;
    if (!grows(unstable))
      return unstable;
    while (unstable - stable > width * stable)
      {
        const double middle                 = 0.5 * (stable + unstable);
        (grows(middle) ? unstable : stable) = middle;
      }
    return stable;
  }
} // namespace springfit
