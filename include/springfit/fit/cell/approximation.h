#ifndef springfit_fit_cell_approximation_h
#define springfit_fit_cell_approximation_h

#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

#include <functional>

namespace springfit
{
  /**
   * A fit of the constants of @p terms to the stiffness of a cell, the first
   * @p n_nonnegative of which must not be negative.
   */
  using FitOfTerms = std::function<FittedCell(const CellTerms &terms,
                                              Eigen::Index n_nonnegative)>;

  /**
   * The forces of a cell by a fit to its stiffness.
   *
   * With all couplings a cell is exact, whatever a fit minimises, and the fit
   * is not asked.
   *
   * With FitOptions::nonnegative springs are >= 0, and the others free as long
   * as the cell releases energy in no deformation: where it does, the fit with
   * all constants >= 0 cannot, and the cell is moved from that towards the
   * wanted one, as far as it stays definite. No cell is left a mechanism, see
   * without_mechanisms().
   *
   * @throws RunError as the fit does, or when a volume is zero or an angle
   * straight or folded.
   */
  FittedCell
  approximate(const FitProblem &problem,
              const FitOptions &options,
              const FitOfTerms &fit);
} // namespace springfit

#endif
