#ifndef springfit_response_statements_h
#define springfit_response_statements_h

#include <string>
#include <vector>

namespace springfit
{
  /**
   * What a user says of a place: "press on top, side: 0, 0, -2" are the values
   * 0, 0 and -2 at the place "top, side" in the load case "press". The case and
   * the values may be left out.
   */
  struct Statement
  {
    std::string load_case;
    std::string place;
    std::vector<std::string> values;
  };

  /**
   * The statements of a text, between semicolons. Semicolons, colons and commas
   * in double quotes or in brackets do not separate.
   *
   * @throws EntryError when a statement names no place. @p entry names the
   * parameter.
   */
  std::vector<Statement>
  parse_statements(const std::string &text, const std::string &entry);

  /**
   * The pieces of a text between separators outside of quotes and brackets,
   * without blanks at their ends. Of an empty text none.
   */
  std::vector<std::string>
  split_outside(const std::string &text, char separator);

  /** The condition of a place "where x < 1e-6", or nothing. */
  std::string
  condition_of(const std::string &place);
} // namespace springfit

#endif
