#ifndef springfit_fit_cell_ipopt_engine_h
#define springfit_fit_cell_ipopt_engine_h

#include <springfit/fit/cell/spectral.h>

#include <string>

namespace springfit
{
  /**
   * Solve the spectral fit as a smooth convex program in the pivots with
   * Ipopt (Waechter and Biegler 2006), to the point of the central path with
   * parameter @p mu.
   *
   * Not to be called from several threads: MUMPS is not thread-safe.
   *
   * @throws RunError when Ipopt ends without any point.
   */
  SpectralSolution
  solve_by_ipopt(const SpectralProblem &problem, double mu);

  /**
   * What Ipopt's own derivative checker (first and second derivatives by
   * finite differences at the starting point) reports.
   */
  std::string
  derivative_report(const SpectralProblem &problem);
} // namespace springfit

#endif
