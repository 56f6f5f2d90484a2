#ifndef springfit_mesh_specimen_outline_h
#define springfit_mesh_specimen_outline_h

#include <springfit/mesh/interval.h>

#include <vector>

namespace springfit
{
  /**
   * The tensile specimen of Natsupakpong and Cavusoglu (2010), Table 4, about
   * the axis x from 0 to its length of 16 B: a grip (3 B), a transition (4 B),
   * the straight part (2 B), a transition and a grip. Its width goes from 3 B
   * to B and back; the straight part's is the gauge width.
   *
   * The paper's contour of the transition is not published. Here it is the
   * smooth step 6 t^5 - 15 t^4 + 10 t^3, whose slope and curvature vanish at
   * both ends: the outline has continuous second derivatives (C2).
   */
  struct SpecimenOutline
  {
    double length; // m
    double width;  // of the grips, m

    double
    gauge_width() const
    {
      return width / 3.;
    }

    /** Half the width at @p x in [0, length], in m. */
    double
    half_width(double x) const;

    /** Where the grips, transitions and the straight part meet: 6 x in m. */
    std::vector<double>
    joints() const;

    Interval
    straight_part() const;

    double
    transition_length() const
    {
      return 0.25 * length;
    }
  };

  /** 6 t^5 - 15 t^4 + 10 t^3 for t in [0, 1], and 0 or 1 beyond. */
  double
  smooth_step(double t);
} // namespace springfit

#endif
