#ifndef springfit_calibration_packed_fit_h
#define springfit_calibration_packed_fit_h

#include <springfit/fit/fit.h>

#include <vector>

namespace springfit
{
  // The result of a fit as a plain row of numbers, which ranks can exchange.

  std::vector<double>
  pack(const FitResult &result);

  FitResult
  unpack(const std::vector<double> &numbers);
} // namespace springfit

#endif
