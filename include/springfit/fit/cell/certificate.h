#ifndef springfit_fit_cell_certificate_h
#define springfit_fit_cell_certificate_h

#include <springfit/fit/cell/spectral.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * A lower bound of min_k ||E(k)||_2 from any symmetric matrices M and Y3,
   * good when they are near the optimal multipliers Y1 - Y2 and Y3, and valid
   * whatever they are. (Y3, of A3, loses its negative eigenvalues first;
   * without A3 it is zero.)
   *
   * M is replaced by its projection (in Frobenius' norm) on the matrices with
   * v_s = b_s^T (M + Y3) b_s = 0 for every spring, or <= 0 where k >= 0 is
   * asked. Then for every admissible k
   *   <R, M> + <F, Y3> <= <E(k), M> <= ||E(k)||_2 |M|,
   * |M| the sum of the magnitudes of M's eigenvalues. The projection is a
   * Frobenius fit of M + Y3 itself. Of a sliver rounding leaves v_s that are
   * not zero: the sum of |v_s| times the largest |k_s| that a minimiser can
   * have is subtracted, which an admissible k with ||E(k)||_2 = @p value
   * bounds: a minimiser has ||B diag(k) B^T|| <= ||R|| + value.
   */
  double
  dual_bound(const SpectralProblem &problem,
             const SpectralSolution &multipliers,
             double value);

  /**
   * ||E(k)||_2 minus the bound of the solution's multiplier: at most this far
   * is k from the optimum. Relative to ||R||_2.
   */
  double
  duality_gap(const SpectralProblem &problem, const SpectralSolution &solution);
} // namespace springfit

#endif
