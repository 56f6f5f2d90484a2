#ifndef springfit_response_expression_h
#define springfit_response_expression_h

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace springfit
{
  /**
   * A number that a user writes as an expression of the place x, y (and z), in
   * m, and of the time t, in s: "1000 * (1 - cos(2 * pi * t / 0.5)) / 2". The
   * words and, or, not stand beside muParser's own, and pi is known.
   */
  template <int dim>
  class Expression
  {
  public:
    // Both: @p entry names the parameter in errors, and @p advice says what to
    // write instead, a full sentence.
    // @throws EntryError when the expression cannot be understood.

    static Expression
    of_place(const std::string &text,
             const std::string &entry,
             const std::string &advice);

    static Expression
    of_place_and_time(const std::string &text,
                      const std::string &entry,
                      const std::string &advice);

    /** @throws EntryError when the expression has no finite value there. */
    double
    value(const dealii::Point<dim> &point, double time) const;

    /** Whether it names x, y or z. */
    bool
    depends_on_place() const;

    bool
    depends_on_time() const;

  private:
    Expression(const std::string &text,
               const std::string &entry,
               const std::string &advice,
               const std::string &variables);

    const std::string text_;
    const std::string entry_;
    const std::string advice_;

    // deal.II's parser takes the time apart from the point.
    std::shared_ptr<dealii::FunctionParser<dim>> function_;
  };
} // namespace springfit

#endif
