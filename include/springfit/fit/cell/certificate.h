#ifndef springfit_fit_cell_certificate_h
#define springfit_fit_cell_certificate_h

#include <springfit/fit/cell/spectral.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * A lower bound of min_k ||E(k)||_2 from any symmetric matrix @p M, good
   * when M is near the optimal multiplier Y1 - Y2, and valid whatever it is.
   *
   * M is first replaced by its projection (in Frobenius' norm) on the
   * matrices with b_s^T M b_s = 0 for every spring, or <= 0 where k >= 0 is
   * asked. Then for every admissible k
   *   <R, M> <= <E(k), M> <= ||E(k)||_2 |M|,
   * |M| the sum of the magnitudes of M's eigenvalues. The projection is a
   * Frobenius fit of M itself.
   */
  double
  dual_bound(const SpectralProblem &problem, const Eigen::MatrixXd &M);

  /**
   * ||E(k)||_2 minus the bound of the solution's multiplier: at most this far
   * is k from the optimum. Relative to ||R||_2.
   */
  double
  duality_gap(const SpectralProblem &problem, const SpectralSolution &solution);
} // namespace springfit

#endif
