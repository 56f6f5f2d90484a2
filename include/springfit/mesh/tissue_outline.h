#ifndef springfit_mesh_tissue_outline_h
#define springfit_mesh_tissue_outline_h

#include <array>

namespace springfit
{
  /**
   * An arbitrary closed outline, smooth and convex like a piece of tissue. With
   * c = cos(angle), s = sin(angle), counter-clockwise for angles from 0 to
   * 2 pi:
   *
   *   x = length / 2 (1 + (c - 0.08 cos(3 angle)) / 0.92)
   *   y = width / 2 (1 + s (1 + 0.2 c^2 + 0.25 c^3) - 0.2 c^2)
   *
   * x goes from 0 (at pi) to the length (at 0), strictly monotone between
   * them; y goes from 0 (at -pi/2) to the width (at pi/2). The outline of the
   * paper's tissue is not published.
   */
  struct TissueOutline
  {
    double length; // m
    double width;  // m

    /** x, y in m. */
    std::array<double, 2>
    point(double angle) const;

    /** Its derivative by the angle, in m. */
    std::array<double, 2>
    tangent(double angle) const;

    /** The angle in [0, pi] at which x is that; @p x in [0, length], in m. */
    double
    upper_angle(double x) const;

    /** The angle of the point of the outline that is nearest to x, y (in m). */
    double
    nearest_angle(double x, double y) const;
  };
} // namespace springfit

#endif
