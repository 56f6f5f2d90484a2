#include <springfit/core/error.h>
#include <springfit/studies/stability_section.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace springfit
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    enum class Combination
    {
      one_at_a_time,
      grid
    };

    const WordTable<Combination> &
    combination_words()
    {
      static const WordTable<Combination> table = {{Combination::one_at_a_time,
                                                    "one at a time"},
                                                   {Combination::grid, "grid"}};
      return table;
    }

    std::string
    text_of(const double number)
    {
      std::ostringstream text;
      text << number;
      return text.str();
    }

    /** So many points as variations() makes. */
    double
    n_variations(const StabilitySettings &settings)
    {
      double sum = 1., product = 1.;
      for (const auto &axis : settings.axes)
        {
          sum += axis.values.size();
          product *= axis.values.size();
        }
      return settings.is_grid ? product + 1. : sum;
    }
  } // namespace

  const WordTable<StabilityAxis> &
  stability_axis_words()
  {
    static const WordTable<StabilityAxis> table = {
      {StabilityAxis::poissons_ratio, "poissons_ratio"},
      {StabilityAxis::youngs_modulus, "youngs_modulus_Pa"},
      {StabilityAxis::size, "size_m"},
      {StabilityAxis::aspect_ratio, "aspect_ratio"},
      {StabilityAxis::angle, "angle_degrees"},
      {StabilityAxis::contrast, "contrast"},
      {StabilityAxis::stretch, "stretch"},
      {StabilityAxis::inversion, "inversion"},
      {StabilityAxis::time_step, "time_step_s"}};
    return table;
  }


  std::optional<double>
  value_of(const Variation &variation, const StabilityAxis axis)
  {
    const auto found = variation.find(axis);
    return found == variation.end() ? std::nullopt
                                    : std::optional<double>(found->second);
  }


  std::vector<Variation>
  variations(const StabilitySettings &settings)
  {
    std::vector<Variation> points = {{}};
    if (!settings.is_grid)
      {
        for (const auto &axis : settings.axes)
          for (const double value : axis.values)
            points.push_back({{axis.axis, value}});
        return points;
      }
    std::vector<Variation> grid = {{}};
    for (const auto &axis : settings.axes)
      {
        std::vector<Variation> finer;
        for (const auto &point : grid)
          for (const double value : axis.values)
            {
              finer.push_back(point);
              finer.back()[axis.axis] = value;
            }
        grid = finer;
      }
    points.insert(points.end(), grid.begin(), grid.end());
    return points;
  }


  template <int dim>
  void
  StabilitySection<dim>::add_axis(const StabilityAxis axis,
                                  const std::string &entry,
                                  const Spacing spacing,
                                  const double above,
                                  const double below,
                                  const std::string &values,
                                  const std::string &help)
  {
    axes_.push_back({axis, entry, spacing, above, below, values});
    add_parameter(entry,
                  axes_.back().text,
                  help + " Empty: it does not vary. " + number_list_help() +
                    (spacing == Spacing::uniform
                       ? ", spaced uniformly."
                       : ", spaced logarithmically."));
  }


  template <int dim>
  StabilitySection<dim>::StabilitySection()
    : dealii::ParameterAcceptor("Stability")
  {
    axes_.reserve(9); // deal.II keeps their addresses
    add_axis(StabilityAxis::poissons_ratio,
             "Poisson's ratios",
             Spacing::uniform,
             -1.,
             1.,
             "-0.99, -0.9, -0.5, 0, 0.25, 0.45, 0.49, 0.499, 0.4999",
             "Of all materials (no unit).");
    add_axis(StabilityAxis::youngs_modulus,
             "Young's moduli",
             Spacing::logarithmic,
             0.,
             infinity,
             "1e-3 to 1e12 in 4",
             "Of the first material, Pa; others change in proportion.");
    add_axis(StabilityAxis::size,
             "Sizes",
             Spacing::logarithmic,
             0.,
             infinity,
             "1e-6 to 1e3 in 4",
             "Largest extent of the object, m.");
    add_axis(StabilityAxis::aspect_ratio,
             "Aspect ratios",
             Spacing::logarithmic,
             0.,
             infinity,
             "1, 3, 10, 100, 1000, 10000",
             "How many times shorter the object and its cells are along the "
             "last direction than in the scene (no unit).");
    add_axis(StabilityAxis::angle,
             "Angles",
             Spacing::logarithmic,
             0.,
             90.1,
             "90, 60, 30, 10, 3, 1, 0.3, 0.1",
             "To which the right angle between the first direction and the "
             "last is sheared, degrees: cells become slivers.");
    add_axis(StabilityAxis::contrast,
             "Contrasts",
             Spacing::logarithmic,
             0.,
             infinity,
             "1e-6 to 1e6 in 5",
             "How many times stiffer than in the scene the half of the object "
             "is whose x is large (no unit).");
    add_axis(StabilityAxis::stretch,
             "Stretches",
             Spacing::uniform,
             0.,
             infinity,
             "0.1, 0.3, 0.5, 0.7, 0.9, 1, 1.5, 2, 3",
             "Length by length at rest along the longest direction of the "
             "object, whose ends are held (no unit). Of nonlinear models.");
    add_axis(StabilityAxis::inversion,
             "Inversions",
             Spacing::uniform,
             0.,
             infinity,
             "0.5, 1, 1.5, 2",
             "How far the node in the middle of the object is pushed at the "
             "beginning, in edges of its cells (no unit): beyond about 1 cells "
             "are turned inside out. Of nonlinear models.");
    add_axis(StabilityAxis::time_step,
             "Time steps",
             Spacing::logarithmic,
             0.,
             infinity,
             "1e-5 to 1 in 6",
             "Of a motion under the first load case, s.");
    add_parameter("Combine",
                  combine_,
                  "What is varied: " +
                    join(words_of(combination_words()), " or ") +
                    " (no unit). One at a time leaves all others as the scene "
                    "has them; a grid has all of them together.");
    add_parameter(
      "Width",
      width_,
      "Between two values with different verdicts their boundary is "
      "sought until it is known to this part of their distance (no "
      "unit), less than 1; 0: it is not sought.");
    add_parameter("Integrators",
                  integrators_,
                  "Of 'Time steps', between commas: " +
                    join(words_of(integrator_words())) + " (no unit).");
    add_parameter("Steps",
                  n_steps_,
                  "Of each motion that is observed (no unit), 100 to 1000000.",
                  prm,
                  dealii::Patterns::Integer(0));
  }


  template <int dim>
  StabilitySettings
  StabilitySection<dim>::settings() const
  {
    StabilitySettings settings;
    for (const auto &axis : axes_)
      {
        if (axis.text.find_first_not_of(" \t") == std::string::npos)
          continue;
        const std::string entry = "Stability/" + axis.entry;
        AxisValues values{axis.axis,
                          parse_number_list(axis.text, axis.spacing, entry),
                          axis.spacing};
        for (const double value : values.values)
          if (!(value > axis.above && value < axis.below))
            throw EntryError(entry,
                             text_of(value) + " is out of range.",
                             "Give numbers above " + text_of(axis.above) +
                               (axis.below < infinity
                                  ? " and below " + text_of(axis.below)
                                  : "") +
                               '.');
        std::sort(values.values.begin(), values.values.end());
        settings.axes.push_back(values);
      }
    if (settings.axes.empty())
      throw EntryError("Stability/Poisson's ratios",
                       "nothing varies: this axis has no values, nor has any "
                       "other.",
                       "Give values to one of them, such as " +
                         number_list_help() + '.');
    settings.is_grid =
      value_of(combination_words(), combine_, "Stability/Combine") ==
      Combination::grid;
    if (!(width_ >= 0. && width_ < 1.))
      throw EntryError("Stability/Width",
                       text_of(width_) + " is out of range.",
                       "Give a number from 0 to 1, such as 0.05.");
    settings.width = width_;
    settings.integrators =
      values_of(integrator_words(), integrators_, "Stability/Integrators");
    if (n_steps_ < 100 || n_steps_ > 1000000)
      throw EntryError("Stability/Steps",
                       std::to_string(n_steps_) + " is out of range.",
                       "Give a number from 100 to 1000000.");
    settings.n_steps = n_steps_;
    return settings;
  }


  template <int dim>
  void
  StabilitySection<dim>::check(const Material<dim> &material,
                               const std::size_t n_models) const
  {
    const auto settings = this->settings();
    for (const auto &axis : settings.axes)
      for (const double value : axis.values)
        {
          if (axis.axis == StabilityAxis::poissons_ratio)
            material.check_poissons_ratio(value, "Stability/Poisson's ratios");
          if (axis.axis == StabilityAxis::youngs_modulus)
            material.check_youngs_modulus(value, "Stability/Young's moduli");
        }
    constexpr double most = 1e6;
    const double n_rows   = n_variations(settings) * n_models;
    if (n_rows > most)
      throw EntryError("Stability/Combine",
                       "there would be " + text_of(n_rows) +
                         " rows, more than a million.",
                       "Set it to 'one at a time', or give fewer values.");
  }

  template class StabilitySection<2>;
  template class StabilitySection<3>;
} // namespace springfit
