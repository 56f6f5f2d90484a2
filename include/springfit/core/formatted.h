#ifndef springfit_core_formatted_h
#define springfit_core_formatted_h

#include <cstdio>
#include <string>

namespace springfit
{
  /** What std::printf() would print, whole. */
  template <typename... Arguments>
  std::string
  formatted(const char *format, Arguments... arguments)
  {
    std::string text(std::snprintf(nullptr, 0, format, arguments...), ' ');
    std::snprintf(text.data(), text.size() + 1, format, arguments...);
    return text;
  }
} // namespace springfit

#endif
