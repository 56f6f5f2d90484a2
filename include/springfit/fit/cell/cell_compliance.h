#ifndef springfit_fit_cell_cell_compliance_h
#define springfit_fit_cell_cell_compliance_h

#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

namespace springfit
{
  /**
   * Of a cell, see approximation.h: the fit of compliance.h with the cell as an
   * object of its own.
   */
  FittedCell
  fit_compliance(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
