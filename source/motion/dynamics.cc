#include <springfit/core/error.h>
#include <springfit/motion/dynamics.h>
#include <springfit/response/statements.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace springfit
{
  namespace
  {
    const WordTable<MassKind> &
    mass_words()
    {
      static const WordTable<MassKind> table = {{MassKind::lumped, "lumped"},
                                                {MassKind::consistent,
                                                 "consistent"}};
      return table;
    }

    std::string
    text_of(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }

    std::string
    full_name(const std::string &entry)
    {
      return "Dynamics/" + entry;
    }

    void
    check_not_negative(const double value, const std::string &entry)
    {
      if (!(value >= 0. && std::isfinite(value)))
        throw EntryError(full_name(entry),
                         text_of(value) + " is negative or not finite.",
                         "Give a number from 0 on.");
    }

    /** A finite number, or nothing. */
    std::optional<double>
    number_in(const std::string &text)
    {
      char *end            = nullptr;
      const double value   = std::strtod(text.c_str(), &end);
      const bool is_number = end != text.c_str() && *end == '\0';
      if (!is_number || !std::isfinite(value))
        return {};
      return value;
    }

    Opening
    opening(const Statement &statement, const double begin, const double end)
    {
      const std::string entry = full_name("Openings");
      const auto time         = statement.values.size() == 1
                                  ? number_in(statement.values[0])
                                  : std::nullopt;
      const Opening opening{condition_of(statement.place), time.value_or(0.)};
      if (!time || opening.condition.empty() || !statement.load_case.empty())
        throw EntryError(entry,
                         "'" + statement.place +
                           "' is no condition with a time.",
                         "Write \"where x < 0.01: 0.2\", with a time in s.");
      if (!(opening.time >= begin && opening.time < end))
        throw EntryError(entry,
                         text_of(opening.time) +
                           " s is no time of the motion, which goes from " +
                           text_of(begin) + " to " + text_of(end) + " s.",
                         "Give one between them.");
      return opening;
    }

    template <int dim>
    NamedPoint<dim>
    named_point(const Statement &statement)
    {
      const std::string entry = full_name("Points");
      NamedPoint<dim> point{statement.place, {}};
      const EntryError wrong(entry,
                             "'" + statement.place +
                               "' is no name with a place.",
                             "Write a name of letters, digits and "
                             "underscores, a colon, and " +
                               std::to_string(dim) +
                               " numbers in m between commas: \"tip: " +
                               (dim == 2 ? "0.02, 0\"." : "0.02, 0, 0\"."));
      if (
        statement.values.size() != dim || !statement.load_case.empty() ||
        statement.place.find_first_not_of(
          "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_") !=
          std::string::npos)
        throw wrong;
      for (int d = 0; d < dim; ++d)
        {
          const auto coordinate = number_in(statement.values[d]);
          if (!coordinate)
            throw wrong;
          point.place[d] = *coordinate;
        }
      return point;
    }
  } // namespace

  const WordTable<Integrator> &
  integrator_words()
  {
    static const WordTable<Integrator> table = {
      {Integrator::implicit_euler, "implicit euler"},
      {Integrator::generalised_alpha, "generalised alpha"},
      {Integrator::newmark, "newmark"},
      {Integrator::symplectic_euler, "symplectic euler"}};
    return table;
  }

  template <int dim>
  Dynamics<dim>::Dynamics() : dealii::ParameterAcceptor("Dynamics")
  {
    add_parameter("Integrator",
                  integrator_word_,
                  "How time is stepped through: " +
                    join(words_of(integrator_words()), " or ") +
                    " (no unit). Implicit Euler damps and bears every step, "
                    "generalised alpha and Newmark are of second order, "
                    "symplectic Euler is explicit and needs a small step.");
    add_parameter("Start time", begin_, "When the motion begins, at rest, s.");
    add_parameter("End time", end_, "When it ends, s; after the start.");
    add_parameter("Time step",
                  step_,
                  "Step in s, positive. For symplectic Euler below the "
                  "stability limit, which a run prints; 0 takes nine tenths of "
                  "that.");
    add_parameter("Linearisations",
                  n_iterations_,
                  "Of an implicit step, at most (no unit): 1 solves the linear "
                  "equations of the step's beginning once, more go on by "
                  "Newton's method to the tolerance. Generalised alpha and "
                  "Newmark always do, in 20 at most.",
                  prm,
                  dealii::Patterns::Integer(0));
    add_parameter("Tolerance",
                  tolerance_,
                  "Of the equations of a step: the forces left over, relative "
                  "(no unit), between 1e-14 and 0.1.");
    add_parameter("Spectral radius",
                  spectral_radius_,
                  "Of generalised alpha for motions of infinite frequency (no "
                  "unit): 1 damps nothing, 0 them wholly in one step.");
    add_parameter("Newmark",
                  newmark_,
                  "Its beta and gamma (no unit); 0.25, 0.5 is the trapezoidal "
                  "rule.");
    add_parameter("Mass damping",
                  mass_damping_,
                  "alpha of Rayleigh's damping alpha M + beta K, 1/s.");
    add_parameter("Stiffness damping",
                  stiffness_damping_,
                  "beta of Rayleigh's damping alpha M + beta K, s, with the "
                  "tangent stiffness of each step.");
    add_parameter("Spring damper",
                  spring_damper_,
                  "Coefficient of a damper along each spring between two "
                  "nodes, N s/m; the finite elements have none.");
    add_parameter("Finite elements",
                  has_finite_elements_,
                  "Whether the finite elements move beside the springs, for "
                  "comparison (true or false).");
    add_parameter("Mass",
                  mass_word_,
                  "Of the finite elements: " +
                    join(words_of(mass_words()), " or ") +
                    " (no unit). The springs' is lumped, and so is that of "
                    "symplectic Euler.");
    add_parameter("Table interval",
                  table_interval_,
                  "Between rows of the tables, s; 0: every step.");
    add_parameter("Frame interval",
                  frame_interval_,
                  "Between pictures for ParaView, s; 0: none.");
    add_parameter("Checkpoint interval",
                  checkpoint_interval_,
                  "Between states from which a run that was stopped goes on, s "
                  "of the motion; 0: none.");
    add_parameter("Stability checks",
                  checks_,
                  "Steps of symplectic Euler between computations of the "
                  "stability limit in the deformed state (no unit); 0: only "
                  "at rest.",
                  prm,
                  dealii::Patterns::Integer(0));
    add_parameter("Time limit",
                  time_limit_,
                  "Wall time in s after which a run stops; 0: none. The same "
                  "command goes on from the last checkpoint.");
    add_parameter("Points",
                  points_,
                  std::string("Places in m whose nearest node goes into the "
                              "tables, by names: \"tip: ") +
                    (dim == 2 ? "0.02, 0; middle: 0.01, 0.01\"."
                              : "0.02, 0, 0; middle: 0.01, 0.01, 0.01\"."));
    add_parameter("Boundaries",
                  boundaries_,
                  "Boundary ids or names whose mean displacement goes into the "
                  "tables (no unit).");
    add_parameter("Load factor",
                  load_factor_,
                  "Of tension, compression, shear and torsion, as an "
                  "expression of t in s (no unit), such as \"min(t / 0.1, "
                  "1)\". Other loads are expressions of t themselves.");
    add_parameter("Openings",
                  openings_,
                  "Cells that are taken out when something cuts or pierces "
                  "the body, by a condition that all of their vertices meet at "
                  "rest (m) and a time in s, between semicolons: \"where "
                  "x * x + y * y < 1e-6: 0.2\".");
  }

  template <int dim>
  DynamicsSettings<dim>
  Dynamics<dim>::settings() const
  {
    return settings(
      value_of(integrator_words(), integrator_word_, full_name("Integrator")));
  }

  template <int dim>
  RayleighDamping
  Dynamics<dim>::damping() const
  {
    check_not_negative(mass_damping_, "Mass damping");
    check_not_negative(stiffness_damping_, "Stiffness damping");
    return {mass_damping_, stiffness_damping_};
  }

  template <int dim>
  DynamicsSettings<dim>
  Dynamics<dim>::settings(const Integrator integrator) const
  {
    DynamicsSettings<dim> settings;
    settings.integrator = integrator;
    const bool is_explicit =
      settings.integrator == Integrator::symplectic_euler;
    if (!std::isfinite(begin_))
      throw EntryError(full_name("Start time"),
                       text_of(begin_) + " is not finite.",
                       "Give a time in s.");
    if (!(end_ > begin_ && std::isfinite(end_)))
      throw EntryError(full_name("End time"),
                       text_of(end_) + " s is not after the start, " +
                         text_of(begin_) + " s.",
                       "Give a later time.");
    if (!(step_ > 0. || (step_ == 0. && is_explicit)) || !std::isfinite(step_))
      throw EntryError(full_name("Time step"),
                       text_of(step_) + " s is not positive.",
                       "Give a step in s, such as 0.01.");
    if (step_ > end_ - begin_)
      throw EntryError(full_name("Time step"),
                       text_of(step_) + " s is more than the whole motion of " +
                         text_of(end_ - begin_) + " s.",
                       "Give a smaller step.");
    if (n_iterations_ == 0)
      throw EntryError(full_name("Linearisations"),
                       "a step needs one at least.",
                       "Give 1, or more for Newton's method.");
    if (!(tolerance_ >= 1e-14 && tolerance_ <= 0.1))
      throw EntryError(full_name("Tolerance"),
                       text_of(tolerance_) + " is out of range.",
                       "Give a number between 1e-14 and 0.1.");
    if (!(spectral_radius_ >= 0. && spectral_radius_ <= 1.))
      throw EntryError(full_name("Spectral radius"),
                       text_of(spectral_radius_) + " is out of range.",
                       "Give a number between 0 and 1.");
    // Unconditional stability: 2 beta >= gamma >= 1/2 (Hughes 1987, 9.1).
    if (newmark_.size() != 2 || !(newmark_[1] >= 0.5) ||
        !(2. * newmark_[0] >= newmark_[1]))
      throw EntryError(full_name("Newmark"),
                       "beta and gamma are not such that 2 beta >= gamma >= "
                       "1/2.",
                       "Give 0.25, 0.5, for instance.");
    settings.damping = damping();
    check_not_negative(spring_damper_, "Spring damper");
    check_not_negative(table_interval_, "Table interval");
    check_not_negative(frame_interval_, "Frame interval");
    check_not_negative(checkpoint_interval_, "Checkpoint interval");
    check_not_negative(time_limit_, "Time limit");

    settings.begin  = begin_;
    settings.end    = end_;
    settings.step   = step_;
    settings.newton = {tolerance_, n_iterations_};
    settings.method = settings.integrator == Integrator::newmark
                        ? newmark(newmark_[0], newmark_[1])
                        : generalised_alpha(spectral_radius_);
    if (settings.integrator != Integrator::implicit_euler)
      settings.newton.n_iterations = 20;
    settings.spring_damper       = spring_damper_;
    settings.has_finite_elements = has_finite_elements_;
    settings.mass = value_of(mass_words(), mass_word_, full_name("Mass"));
    if (is_explicit && settings.mass == MassKind::consistent)
      throw EntryError(full_name("Mass"),
                       "symplectic Euler's method divides by lumped masses.",
                       "Set it to lumped, or choose another 'Integrator'.");
    settings.table_interval       = table_interval_;
    settings.frame_interval       = frame_interval_;
    settings.checkpoint_interval  = checkpoint_interval_;
    settings.steps_between_checks = checks_;
    settings.time_limit           = time_limit_;
    for (const auto &statement : parse_statements(points_, full_name("Points")))
      settings.points.push_back(named_point<dim>(statement));
    settings.boundaries  = split_at_commas(boundaries_);
    settings.load_factor = load_factor_;
    for (const auto &statement :
         parse_statements(openings_, full_name("Openings")))
      settings.openings.push_back(opening(statement, begin_, end_));
    std::stable_sort(settings.openings.begin(),
                     settings.openings.end(),
                     [](const Opening &a, const Opening &b) {
                       return a.time < b.time;
                     });
    return settings;
  }

  template class Dynamics<2>;
  template class Dynamics<3>;
} // namespace springfit
