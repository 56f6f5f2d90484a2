#include <springfit/core/error.h>
#include <springfit/studies/adapt_section.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <sstream>

namespace springfit
{
  template <int dim>
  AdaptSection<dim>::AdaptSection() : dealii::ParameterAcceptor("Adapt")
  {
    add_parameter("Accuracy",
                  accuracy_,
                  "Wanted error, in % of what the exact model of the mesh has, "
                  "the finite elements: of 'Quantity', or else the root mean "
                  "square distance of the nodes in % of the largest "
                  "displacement; positive.");
    add_parameter("Quantity",
                  quantity_,
                  std::string("As in section Tradeoff: \"displacement of "
                              "BOUNDARY: x\", \"displacement at ") +
                    (dim == 2 ? "0.01, 0.02: y" : "0.01, 0.01, 0.02: z") +
                    "\", \"reaction of SUPPORT: x\" (no unit). Empty: the "
                    "displacement of all nodes.");
    add_parameter("Cycles",
                  n_cycles_,
                  "At most so many times cells are given richer models (no "
                  "unit), 1 to 100.",
                  prm,
                  dealii::Patterns::Integer(0));
    add_parameter("Finite elements",
                  has_finite_elements_,
                  "Whether cells for which the fits of section Fit are not "
                  "good enough become finite elements (true or false). Without "
                  "them the last fit should be exact.");
    add_parameter("True error",
                  knows_true_error_,
                  "Whether the exact model is solved as well, to tell how good "
                  "the estimates are (true or false).");
  }

  template <int dim>
  AdaptSettings
  AdaptSection<dim>::settings() const
  {
    if (!(accuracy_ > 0. && std::isfinite(accuracy_)))
      {
        std::ostringstream what;
        what << accuracy_ << " % is not positive and finite.";
        throw EntryError("Adapt/Accuracy",
                         what.str(),
                         "Give a percentage, such as 1.");
      }
    if (n_cycles_ < 1 || n_cycles_ > 100)
      throw EntryError("Adapt/Cycles",
                       std::to_string(n_cycles_) + " is out of range.",
                       "Give a number from 1 to 100.");
    AdaptSettings settings{
      accuracy_, {}, n_cycles_, has_finite_elements_, knows_true_error_};
    if (!quantity_.empty())
      settings.quantity = parse_quantity(quantity_, dim, "Adapt/Quantity");
    return settings;
  }

  template class AdaptSection<2>;
  template class AdaptSection<3>;
} // namespace springfit
