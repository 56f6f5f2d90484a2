#include <springfit/core/error.h>
#include <springfit/response/statements.h>

#include <regex>

namespace springfit
{
  namespace
  {
    std::string
    trimmed(const std::string &text)
    {
      const auto first = text.find_first_not_of(" \t");
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(" \t") - first + 1);
    }

    Statement
    parse_statement(const std::string &text, const std::string &entry)
    {
      const auto sides = split_outside(text, ':');
      const auto wrong = [&](const std::string &what) {
        return EntryError(entry,
                          "'" + text + "' " + what,
                          "Write a boundary or \"where\" and a condition, a "
                          "colon, and the values between commas; before them a "
                          "load case with \"on\", if need be: \"press on top: "
                          "0, 0, -2\".");
      };
      if (sides.size() > 2)
        throw wrong("has more than one colon.");
      Statement statement;
      statement.place = sides[0];
      std::smatch match;
      if (std::regex_match(statement.place,
                           match,
                           std::regex(
                             "([A-Za-z_][A-Za-z0-9_-]*)\\s+on\\s+(.+)")))
        {
          statement.load_case = match[1];
          statement.place     = std::string(match[2]);
        }
      else if (std::regex_match(statement.place,
                                std::regex("(?!where\\s)[^\"]+\\son\\s.+")))
        throw wrong(
          "has no name of a load case before \"on\": letters, digits, "
          "underscores and hyphens. A boundary with \"on\" in its "
          "name stands in double quotes.");
      if (statement.place.empty())
        throw wrong("names no place.");
      if (sides.size() == 2)
        statement.values = split_outside(sides[1], ',');
      return statement;
    }
  } // namespace

  std::vector<std::string>
  split_outside(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces;
    if (trimmed(text).empty())
      return pieces;
    std::string piece;
    int depth    = 0;
    bool in_name = false;
    for (const char c : text)
      {
        in_name ^= c == '"';
        if (!in_name)
          depth += (c == '(') - (c == ')');
        if (c == separator && !in_name && depth == 0)
          {
            pieces.push_back(trimmed(piece));
            piece.clear();
          }
        else
          piece += c;
      }
    pieces.push_back(trimmed(piece));
    return pieces;
  }

  std::vector<Statement>
  parse_statements(const std::string &text, const std::string &entry)
  {
    std::vector<Statement> statements;
    for (const auto &piece : split_outside(text, ';'))
      if (!piece.empty()) // what is behind a last semicolon
        statements.push_back(parse_statement(piece, entry));
    return statements;
  }

  std::string
  condition_of(const std::string &place)
  {
    std::smatch match;
    return std::regex_match(place, match, std::regex("where\\s+(.+)"))
             ? std::string(match[1])
             : "";
  }
} // namespace springfit
