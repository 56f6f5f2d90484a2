#include <springfit/core/error.h>
#include <springfit/response/region.h>

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
      return std::regex_replace(expression, std::regex("\\bor\\b"), "||");
    }

    /** muParser's own words about what it did not understand. */
    std::string
    reason(const dealii::ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      std::smatch match;
      const auto  info = text.str();
      if (std::regex_search(info, match, std::regex("Message: *<(.*)>\\s")))
        return std::regex_replace(match[1].str(), std::regex("\\s+"), " ");
      return std::regex_replace(info, std::regex("\\s+"), " ");
    }
  } // namespace

  template <int dim>
  Region<dim>::Region(const std::string &expression, const std::string &entry)
    : function_(std::make_unique<dealii::FunctionParser<dim>>(1))
  {
    const std::string names = dim == 2 ? "x,y" : "x,y,z";
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
                         "Write a condition on " + names +
                           " in m, such as \"x < 1e-6\".");
      }
  }

  template <int dim>
  bool
  Region<dim>::contains(const dealii::Point<dim> &point) const
  {
    return function_->value(point) != 0.;
  }

  template class Region<2>;
  template class Region<3>;
} // namespace springfit
