#ifndef springfit_springs_angles_h
#define springfit_springs_angles_h

#include <springfit/springs/family.h>

namespace springfit
{
  /**
   * Springs whose coordinate is the angle theta at the middle one of three
   * nodes, see angle.h: energy k (theta - rest_angle)^2 / 2. Columns k (N m per
   * rad^2) and rest_angle (rad). An angle has no derivatives where it is
   * straight or folded. The ends are in ascending order.
   */
  const SpringKind &
  angles(int dim);
} // namespace springfit

#endif
