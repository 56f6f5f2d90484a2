#include <springfit/core/error.h>
#include <springfit/core/number_list.h>
#include <springfit/studies/sweep_range.h>

#include <cmath>

namespace springfit
{
  template <int dim>
  SweepRange<dim>::SweepRange()
    : dealii::ParameterAcceptor("Sweep"), axis_(dim, 0.)
  {
    axis_[0] = 1.;
    add_parameter("Young's moduli",
                  youngs_moduli_text_,
                  "Young's moduli that a sweep gives to the cell, in Pa, "
                  "positive: " +
                    number_list_help() + ", spaced logarithmically.");
    add_parameter("Poisson's ratios",
                  poissons_ratios_text_,
                  "Poisson's ratios that a sweep gives to the cell (no unit), "
                  "between -1 and 0.5; 0.5 itself is allowed in plane stress "
                  "only: " +
                    number_list_help() + ", spaced uniformly.");
    add_parameter("Axis",
                  axis_,
                  "Direction in which the cell is pulled, of any length (no "
                  "unit).");
  }

  template <int dim>
  void
  SweepRange<dim>::check(const Material<dim> &material) const
  {
    for (const double modulus : youngs_moduli())
      material.check_youngs_modulus(modulus, "Sweep/Young's moduli");
    for (const double ratio : poissons_ratios())
      material.check_poissons_ratio(ratio, "Sweep/Poisson's ratios");
    axis();
  }

  template <int dim>
  std::vector<double>
  SweepRange<dim>::youngs_moduli() const
  {
    return parse_number_list(youngs_moduli_text_,
                             Spacing::logarithmic,
                             "Sweep/Young's moduli");
  }

  template <int dim>
  std::vector<double>
  SweepRange<dim>::poissons_ratios() const
  {
    return parse_number_list(poissons_ratios_text_,
                             Spacing::uniform,
                             "Sweep/Poisson's ratios");
  }

  template <int dim>
  Eigen::VectorXd
  SweepRange<dim>::axis() const
  {
    const Eigen::VectorXd axis =
      Eigen::Map<const Eigen::VectorXd>(axis_.data(), axis_.size());
    const double length = axis.norm();
    if (axis.size() != dim || !(length > 0. && std::isfinite(length)))
      throw EntryError("Sweep/Axis",
                       "it gives no direction in " + std::to_string(dim) +
                         " dimensions.",
                       "Give " + std::to_string(dim) +
                         " numbers, separated by commas, that are not all 0.");
    return axis / length;
  }

  template class SweepRange<2>;
  template class SweepRange<3>;
} // namespace springfit
