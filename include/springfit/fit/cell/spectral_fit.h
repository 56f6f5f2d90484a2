#ifndef springfit_fit_cell_spectral_fit_h
#define springfit_fit_cell_spectral_fit_h

#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

namespace springfit
{
  /**
   * The constants of @p terms that solve @p problem, by FitOptions::engine, and
   * their certified gap.
   *
   * @throws RunError when the engine breaks down without a result.
   */
  FittedCell
  solve(const SpectralProblem &problem,
        const CellTerms &terms,
        const FitOptions &options);

  /**
   * Of a cell, see approximation.h: the minimiser of ||E(k)||_2 (Natsupakpong
   * and Cavusoglu 2010, section 3), with its certificate. With all couplings
   * the gap is what rounding leaves.
   */
  FittedCell
  fit_spectral(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
