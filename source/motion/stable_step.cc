#include <springfit/motion/stable_step.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace springfit
{
  double
  damping_ratio(const RayleighDamping &damping, const double frequency)
  {
    return 0.5 * (damping.mass_factor / frequency +
                  damping.stiffness_factor * frequency);
  }


  double
  stable_step(const RayleighDamping &damping, const double frequency)
  {
    // As 4 / (sqrt(w^2 + d^2) + d) / 2 with d = z w, which bears w = 0.
    const double half = 0.5 * (damping.mass_factor + damping.stiffness_factor *
                                                       frequency * frequency);
    const double sum  = std::hypot(frequency, half) + half;
    return sum > 0. ? 2. / sum : std::numeric_limits<double>::infinity();
  }


  double
  spring_bound_of_step(const SpringNetwork &network,
                       const std::vector<bool> &held)
  {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(network.nodes.cols());
    for (const Family &family : network.families)
      if (family.kind->n_nodes() == 2)
        for (std::size_t m = 0; m < family.size(); ++m)
          for (unsigned int i = 0; i < 2; ++i)
            // Those of k < 0 take stiffness away from every motion.
            sum[family.nodes(m)[i]] +=
              std::max(0., family.members.columns[0][m]);
    double largest = 0.;
    for (Eigen::Index v = 0; v < sum.size(); ++v)
      if (!held[v])
        largest = std::max(largest, sum[v] / network.mass[v]);
    return largest > 0. ? 2. / std::sqrt(2. * largest)
                        : std::numeric_limits<double>::infinity();
  }
} // namespace springfit
