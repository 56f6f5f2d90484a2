#ifndef springfit_springs_spring_law_h
#define springfit_springs_spring_law_h

#include <springfit/core/words.h>

namespace springfit
{
  /**
   * How the elongation of a spring follows from its length l and its rest
   * length L. The energy k q^2 / 2 is of the second or of the fourth degree in
   * the length; both laws have the same tangent at rest.
   */
  enum class SpringLaw
  {
    /** q = l - L: Hooke's spring. */
    quadratic,

    /**
     * q = (l^2 - L^2) / (2 L), which is d^T E d / L with Green's strain E and
     * d at rest: the full couplings of a P1 cell make it St. Venant-Kirchhoff's
     * material (Delingette, IEEE TVCG 14 (2008) 329, "biquadratic springs").
     */
    biquadratic
  };

  const WordTable<SpringLaw> &
  spring_law_words();
} // namespace springfit

#endif
