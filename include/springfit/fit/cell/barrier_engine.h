#ifndef springfit_fit_cell_barrier_engine_h
#define springfit_fit_cell_barrier_engine_h

#include <springfit/fit/cell/spectral.h>

namespace springfit
{
  /**
   * Solve the spectral fit by following the central path, the minimisers of
   *   t / mu - log det A1 - log det A2 [ - sum_s log k_s ],
   * with Newton's method down to the parameter @p mu (Boyd and Vandenberghe
   * 2004, chapter 11). Uses nothing but Eigen and may run in threads.
   *
   * @throws RunError when Newton's method breaks down at the start.
   */
  SpectralSolution
  solve_by_barrier(const SpectralProblem &problem, double mu);
} // namespace springfit

#endif
