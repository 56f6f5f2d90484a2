#ifndef springfit_core_long_values_h
#define springfit_core_long_values_h

#include <springfit/core/parameters.h>

#include <string>

namespace springfit
{
  /**
   * @p message with its long words and with the long values of @p source cut
   * in the middle: nobody reads them to their end. On one line.
   */
  std::string
  without_long_values(std::string message, const ParameterSource &source);
} // namespace springfit

#endif
