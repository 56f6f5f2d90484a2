#include <springfit/mesh/tissue_outline.h>

#include <cmath>

namespace springfit
{
  std::array<double, 2>
  TissueOutline::point(const double angle) const
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {
      {0.5 * length * (1. + (c - 0.08 * std::cos(3. * angle)) / 0.92),
       0.5 * width * (1. + s * (1. + c * c * (0.2 + 0.25 * c)) - 0.2 * c * c)}};
  }


  std::array<double, 2>
  TissueOutline::tangent(const double angle) const
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{0.5 * length * (-s + 0.24 * std::sin(3. * angle)) / 0.92,
             0.5 * width * c *
               (1. + 0.2 * (c * c - 2. * s * s) +
                0.25 * c * (c * c - 3. * s * s) + 0.4 * s)}};
  }


  double
  TissueOutline::upper_angle(const double x) const
  {
    double low = 0., high = M_PI; // x falls from low to high
    for (int bisection = 0; bisection < 60; ++bisection)
      {
        const double middle                 = 0.5 * (low + high);
        (point(middle)[0] > x ? low : high) = middle;
      }
    return 0.5 * (low + high);
  }


  double
  TissueOutline::nearest_angle(const double x, const double y) const
  {
    constexpr int n = 360;
    double nearest = 0., smallest = 1e300;
    for (int i = 0; i < n; ++i)
      {
        const double angle    = 2. * M_PI * i / n;
        const auto p          = point(angle);
        const double distance = std::hypot(p[0] - x, p[1] - y);
        if (distance < smallest)
          {
            smallest = distance;
            nearest  = angle;
          }
      }
    // Gauss and Newton's method: the point is next to the outline.
    for (int iteration = 0; iteration < 20; ++iteration)
      {
        const auto p = point(nearest), t = tangent(nearest);
        nearest +=
          ((x - p[0]) * t[0] + (y - p[1]) * t[1]) / (t[0] * t[0] + t[1] * t[1]);
      }
    return nearest;
  }
} // namespace springfit
