#include <springfit/core/plane_stress.h>

#include <cmath>

namespace springfit
{
  std::optional<double>
  squared_stretch_across(const double log_J_plane,
                         const double lambda_plane,
                         const double mu)
  {
    // The equation times 1 - lambda_plane / (2 mu) holds for every nu <= 0.5.
    // Newton's method in ln c: for nu >= 0 the function is convex and rising,
    // and the start is right of the root or one step away from it.
    const double p = mu - 0.5 * lambda_plane;
    double log_c   = 0.;
    for (int step = 0; step < 100; ++step)
      {
        const double c = std::exp(log_c);
        const double value =
          p * (c - 1.) + lambda_plane * (log_J_plane + 0.5 * log_c);
        const double change = -value / (p * c + 0.5 * lambda_plane);
        log_c += change;
        if (std::abs(change) <= 1e-14 * (1. + std::abs(log_c)))
          return std::exp(log_c);
      }
    return {};
  }
} // namespace springfit
