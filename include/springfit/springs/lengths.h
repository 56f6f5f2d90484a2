#ifndef springfit_springs_lengths_h
#define springfit_springs_lengths_h

#include <springfit/springs/family.h>
#include <springfit/springs/spring_law.h>

namespace springfit
{
  /**
   * Springs whose coordinate is the elongation q of the distance l of two
   * nodes over the rest length L > 0, see SpringLaw: energy k q^2 / 2. Columns
   * k (N/m) and rest_length (m). By the law quadratic a spring has no
   * derivatives where its nodes coincide, l <= 1e-12 L.
   */
  const SpringKind &
  lengths(int dim, SpringLaw law);
} // namespace springfit

#endif
