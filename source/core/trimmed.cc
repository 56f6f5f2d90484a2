#include <springfit/core/trimmed.h>

namespace springfit
{
  std::string
  trimmed(const std::string &text)
  {
    constexpr char blanks[] = " \t\r\n\f\v";
    const auto first        = text.find_first_not_of(blanks);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
  }
} // namespace springfit
