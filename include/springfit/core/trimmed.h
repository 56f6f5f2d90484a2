#ifndef springfit_core_trimmed_h
#define springfit_core_trimmed_h

#include <string>

namespace springfit
{
  /** @p text without the blanks at both ends. */
  std::string
  trimmed(const std::string &text);
} // namespace springfit

#endif
