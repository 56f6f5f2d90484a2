#include <springfit/response/region.h>

namespace springfit
{
  template <int dim>
  Region<dim>::Region(const std::string &expression, const std::string &entry)
    : condition_(
        Expression<dim>::of_place(expression,
                                  entry,
                                  "Write a condition on " +
                                    std::string(dim == 2 ? "x, y" : "x, y, z") +
                                    " in m, such as \"x < 1e-6\"."))
  {}

  template <int dim>
  bool
  Region<dim>::contains(const dealii::Point<dim> &point) const
  {
    return condition_.value(point, 0.) != 0.;
  }

  template class Region<2>;
  template class Region<3>;
} // namespace springfit
