#ifndef springfit_response_region_h
#define springfit_response_region_h

#include <springfit/response/expression.h>

#include <deal.II/base/point.h>

#include <string>

namespace springfit
{
  /**
   * The points where an expression in x, y (and z), in m, holds, such as
   * "x < 1e-6 and y > 0.01".
   */
  template <int dim>
  class Region
  {
  public:
    /**
     * @p entry names the parameter in errors.
     *
     * @throws EntryError when the expression cannot be understood.
     */
    Region(const std::string &expression, const std::string &entry);

    /** @throws EntryError when the expression has no finite value there. */
    bool
    contains(const dealii::Point<dim> &point) const;

  private:
    const Expression<dim> condition_;
  };
} // namespace springfit

#endif
