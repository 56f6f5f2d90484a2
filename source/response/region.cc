#include <springfit/core/error.h>
#include <springfit/core/unexpected.h>
#include <springfit/response/region.h>

#include <cmath>
#include <iostream>
#include <map>
#include <regex>
#include <sstream>

namespace springfit
{
  namespace
  {
    /** muParser writes the logical words as C does. */
    std::string
    with_c_operators(std::string expression)
    {
      expression =
        std::regex_replace(expression, std::regex("\\band\\b"), "&&");
      expression = std::regex_replace(expression, std::regex("\\bor\\b"), "||");
      return std::regex_replace(expression, std::regex("\\bnot\\b"), "!");
    }

    /** muParser's own words about what it did not understand. */
    std::string
    reason(const dealii::ExceptionBase &exception)
    {
      const std::string info = message_of(exception);
      std::string text       = info;
      std::smatch match;
      if (std::regex_search(info, match, std::regex("The parser said: (.*)")))
        text = match[1];
      return text.substr(0, text.find_last_not_of(" .") + 1);
    }

    /** deal.II writes muParser's errors to the screen before it throws. */
    class QuietErrors
    {
    public:
      QuietErrors() : buffer_(std::cerr.rdbuf(nullptr))
      {}

      ~QuietErrors()
      {
        std::cerr.rdbuf(buffer_);
      }

      QuietErrors(const QuietErrors &) = delete;
      QuietErrors &
      operator=(const QuietErrors &) = delete;

    private:
      std::streambuf *const buffer_;
    };
  } // namespace

  namespace
  {
    /** What muParser would take, and what is no condition all the same. */
    void
    check_is_condition(const std::string &expression, const std::string &entry)
    {
      const auto refuse = [&](const std::string &what,
                              const std::string &mend) {
        throw EntryError(entry,
                         "the expression '" + expression + "' " + what,
                         mend);
      };
      // muParser takes a single equals sign for an assignment.
      if (std::regex_search(expression, std::regex("(^|[^=<>!])=([^=]|$)")))
        refuse("has a single equals sign.",
               "Compare by <, >, <=, >= or ==; for a plane of nodes write "
               "abs(x - 0.02) < 1e-6, for instance.");
      // deal.II adds random numbers, the same for no two runs or points.
      if (std::regex_search(expression, std::regex("\\brand(_seed)?\\b")))
        refuse("draws random numbers.",
               "Write a condition on the place alone, such as \"x < 1e-6\".");
      // muParser takes the last of several expressions.
      int depth = 0;
      for (const char c : expression)
        {
          depth += (c == '(') - (c == ')');
          if (c == ',' && depth == 0)
            refuse("has a comma, and so is more than one condition.",
                   "Join conditions by 'and' or 'or': \"x < 1e-6 and y < "
                   "0.01\".");
        }
    }
  } // namespace

  template <int dim>
  Region<dim>::Region(const std::string &expression, const std::string &entry)
    : expression_(expression)
    , entry_(entry)
    , function_(std::make_unique<dealii::FunctionParser<dim>>(1))
  {
    check_is_condition(expression, entry);
    const std::string names = dim == 2 ? "x,y" : "x,y,z";
    const QuietErrors quiet;
    try
      {
        function_->initialize(names,
                              with_c_operators(expression),
                              std::map<std::string, double>());
        function_->value(dealii::Point<dim>());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw EntryError(entry,
                         "the expression '" + expression +
                           "' cannot be understood: " + reason(exception) + '.',
                         "Write a condition on " +
                           std::string(dim == 2 ? "x, y" : "x, y, z") +
                           " in m, such as \"x < 1e-6\".");
      }
  }

  template <int dim>
  bool
  Region<dim>::contains(const dealii::Point<dim> &point) const
  {
    const double value = function_->value(point);
    if (!std::isfinite(value))
      {
        std::ostringstream text;
        text << "the expression '" << expression_
             << "' has no finite value at the point (" << point << ") m.";
        throw EntryError(entry_,
                         text.str(),
                         "Write a condition, such as \"x < 1e-6\".");
      }
    return value != 0.;
  }

  template class Region<2>;
  template class Region<3>;
} // namespace springfit
