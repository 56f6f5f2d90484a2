#include <springfit/mesh/specimen_outline.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  double
  smooth_step(const double t)
  {
    const double s = std::clamp(t, 0., 1.);
    return s * s * s * (10. + s * (6. * s - 15.));
  }


  double
  SpecimenOutline::half_width(const double x) const
  {
    const double from_middle = std::abs(x - 0.5 * length);
    const double t =
      (from_middle - 0.5 * straight_part().length()) / transition_length();
    return 0.5 * (gauge_width() + (width - gauge_width()) * smooth_step(t));
  }


  std::vector<double>
  SpecimenOutline::joints() const
  {
    std::vector<double> x;
    for (const double multiple_of_B : {0., 3., 7., 9., 13., 16.})
      x.push_back(multiple_of_B / 16. * length);
    return x;
  }


  Interval
  SpecimenOutline::straight_part() const
  {
    const auto x = joints();
    return {x[2], x[3]};
  }
} // namespace springfit
