#ifndef springfit_core_parameter_text_h
#define springfit_core_parameter_text_h

#include <istream>
#include <map>
#include <string>
#include <vector>

namespace springfit
{
  /** A `set` line of a parameter file. */
  struct ParameterLine
  {
    std::string entry; // with its sections: "Geometry/Cell size"
    std::string value;
    unsigned int line; // from 1
  };

  /** Every `set` line of a parameter file, in order. */
  std::vector<ParameterLine>
  scan_parameters(std::istream &file);

  /**
   * The text of a parameter file with other values of some entries, by their
   * sections and names as in "Geometry/Cell size": each must have a `set` line
   * in it, as files have that name all entries.
   */
  std::string
  with_entries(const std::string &text,
               const std::map<std::string, std::string> &values);
} // namespace springfit

#endif
