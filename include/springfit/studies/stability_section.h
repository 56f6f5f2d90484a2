#ifndef springfit_studies_stability_section_h
#define springfit_studies_stability_section_h

#include <springfit/core/number_list.h>
#include <springfit/core/words.h>
#include <springfit/motion/dynamics.h>
#include <springfit/reference/material.h>

#include <deal.II/base/parameter_acceptor.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What a study of stability varies about a scene. */
  enum class StabilityAxis
  {
    poissons_ratio,
    youngs_modulus, // Pa
    size,           // m, the largest extent of the object
    aspect_ratio,   // the last direction is so many times shorter
    angle,          // degrees, between the first direction and the last
    contrast,       // of the half of large x
    stretch,        // length by length at rest
    inversion,      // how far a node is pushed through its cells, in edges
    time_step       // s
  };

  /** As columns of tables have them: "poissons_ratio". */
  const WordTable<StabilityAxis> &
  stability_axis_words();

  /** A point of the axes; what is not there is as in the scene. */
  using Variation = std::map<StabilityAxis, double>;

  /** That of an axis, if it has one there. */
  std::optional<double>
  value_of(const Variation &variation, StabilityAxis axis);

  struct AxisValues
  {
    StabilityAxis axis;
    std::vector<double> values; // ascending
    Spacing spacing;            // of what lies between them
  };

  struct StabilitySettings
  {
    std::vector<AxisValues> axes; // those that have values
    bool is_grid;                 // or else one at a time
    double width;                 // of a boundary, relative; 0: none is sought
    std::vector<Integrator> integrators;
    std::uint64_t n_steps; // of each motion
  };

  /**
   * The points that the settings ask for: the scene itself first.
   */
  std::vector<Variation>
  variations(const StabilitySettings &settings);


  /** The section "Stability". */
  template <int dim>
  class StabilitySection : public dealii::ParameterAcceptor
  {
  public:
    StabilitySection();

    /** @throws EntryError when a value is wrong. */
    StabilitySettings
    settings() const;

    /**
     * @param n_models for each variation
     * @throws EntryError when a value is wrong, a material cannot have it, or
     * there would be more than a million rows.
     */
    void
    check(const Material<dim> &material, std::size_t n_models) const;

  private:
    struct Axis
    {
      StabilityAxis axis;
      std::string entry;
      Spacing spacing;
      double above, below; // exclusive bounds
      std::string text;
    };

    void
    add_axis(StabilityAxis axis,
             const std::string &entry,
             Spacing spacing,
             double above,
             double below,
             const std::string &values,
             const std::string &help);

    std::vector<Axis> axes_;
    std::string combine_     = "one at a time";
    double width_            = 0.05;
    std::string integrators_ = "symplectic euler, implicit euler";
    unsigned int n_steps_    = 2000;
  };
} // namespace springfit

#endif
