#ifndef springfit_core_number_list_h
#define springfit_core_number_list_h

#include <string>
#include <vector>

namespace springfit
{
  /** How the numbers of a range follow each other. */
  enum class Spacing
  {
    uniform,
    logarithmic
  };

  /** How a user writes such a list, for the text of an entry. */
  const std::string &
  number_list_help();

  /**
   * The numbers of a list such as "0.1, 1 to 1000 in 4": its items, between
   * commas, are numbers, or ranges "LOWEST to HIGHEST in NUMBER" with both
   * ends. The order is the user's.
   *
   * @throws EntryError when the list or a range is empty, or what is written
   * is no such list. @p entry names the parameter.
   */
  std::vector<double>
  parse_number_list(const std::string &text,
                    Spacing spacing,
                    const std::string &entry);
} // namespace springfit

#endif
