#ifndef springfit_fit_fitted_cell_h
#define springfit_fit_fitted_cell_h

#include <springfit/fit/cell_model.h>

#include <optional>

namespace springfit
{
  /** What a fit makes of a cell: its forces and, of some fits, a certificate.
   */
  struct FittedCell
  {
    CellModel model;

    /** See FitResult::duality_gap. */
    std::optional<double> duality_gap = {};

    /** See FitResult::by_other_engine. */
    bool by_other_engine = false;
  };
} // namespace springfit

#endif
