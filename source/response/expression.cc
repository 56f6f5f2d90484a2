#include <springfit/core/error.h>
#include <springfit/core/unexpected.h>
#include <springfit/response/expression.h>

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

    /** What muParser would take, and what is no number all the same. */
    void
    check_is_expression(const std::string &text,
                        const std::string &entry,
                        const std::string &advice)
    {
      const auto refuse = [&](const std::string &what,
                              const std::string &mend) {
        throw EntryError(entry, "the expression '" + text + "' " + what, mend);
      };
      // muParser takes a single equals sign for an assignment.
      if (std::regex_search(text, std::regex("(^|[^=<>!])=([^=]|$)")))
        refuse("has a single equals sign.",
               "Compare by <, >, <=, >= or ==; for a plane of nodes write "
               "abs(x - 0.02) < 1e-6, for instance.");
      // deal.II adds random numbers, the same for no two runs or points.
      if (std::regex_search(text, std::regex("\\brand(_seed)?\\b")))
        refuse("draws random numbers.", advice);
      // muParser takes the last of several expressions.
      int depth = 0;
      for (const char c : text)
        {
          depth += (c == '(') - (c == ')');
          if (c == ',' && depth == 0)
            refuse("has a comma, and so is more than one condition.",
                   "Join conditions by 'and' or 'or': \"x < 1e-6 and y < "
                   "0.01\".");
        }
    }

    template <int dim>
    const char *
    names_of_place()
    {
      return dim == 2 ? "x,y" : "x,y,z";
    }

    bool
    has_word(const std::string &text, const std::string &words)
    {
      return std::regex_search(text, std::regex("\\b(" + words + ")\\b"));
    }
  } // namespace

  template <int dim>
  Expression<dim>
  Expression<dim>::of_place(const std::string &text,
                            const std::string &entry,
                            const std::string &advice)
  {
    return Expression(text, entry, advice, names_of_place<dim>());
  }

  template <int dim>
  Expression<dim>
  Expression<dim>::of_place_and_time(const std::string &text,
                                     const std::string &entry,
                                     const std::string &advice)
  {
    return Expression(text,
                      entry,
                      advice,
                      std::string(names_of_place<dim>()) + ",t");
  }

  template <int dim>
  Expression<dim>::Expression(const std::string &text,
                              const std::string &entry,
                              const std::string &advice,
                              const std::string &variables)
    : text_(text)
    , entry_(entry)
    , advice_(advice)
    , function_(std::make_shared<dealii::FunctionParser<dim>>(1))
  {
    check_is_expression(text, entry, advice);
    const QuietErrors quiet;
    try
      {
        function_->initialize(variables,
                              with_c_operators(text),
                              {{"pi", M_PI}},
                              variables != names_of_place<dim>());
        function_->value(dealii::Point<dim>());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw EntryError(entry,
                         "the expression '" + text +
                           "' cannot be understood: " + reason(exception) + '.',
                         advice);
      }
  }

  template <int dim>
  double
  Expression<dim>::value(const dealii::Point<dim> &point,
                         const double time) const
  {
    function_->set_time(time);
    const double value = function_->value(point);
    if (!std::isfinite(value))
      {
        std::ostringstream text;
        text << "the expression '" << text_
             << "' has no finite value at the point (" << point << ") m";
        if (depends_on_time())
          text << " and the time " << time << " s";
        throw EntryError(entry_, text.str() + '.', advice_);
      }
    return value;
  }

  template <int dim>
  bool
  Expression<dim>::depends_on_place() const
  {
    return has_word(text_, "x|y|z");
  }

  template <int dim>
  bool
  Expression<dim>::depends_on_time() const
  {
    return has_word(text_, "t");
  }

  template class Expression<2>;
  template class Expression<3>;
} // namespace springfit
