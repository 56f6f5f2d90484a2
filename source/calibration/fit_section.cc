#include <springfit/calibration/fit_section.h>
#include <springfit/calibration/states.h>
#include <springfit/core/error.h>
#include <springfit/core/words.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
    std::string
    object_words()
    {
      std::vector<std::string> words;
      for (const Method method : object_methods())
        words.push_back(word_of(method_words(), method));
      return join(words, " and ");
    }

    std::string
    nonlinear_law_words()
    {
      std::vector<std::string> words;
      for (const auto &[law, word] : material_law_words())
        if (law != MaterialLaw::linear)
          words.push_back(word);
      return join(words, " or ");
    }

    /** @throws EntryError when there is no such fit of the whole object. */
    void
    check_object_scope(const Method method)
    {
      const auto &known = object_methods();
      if (std::find(known.begin(), known.end(), method) == known.end())
        throw EntryError(
          "Fit/Scope",
          "the fit '" + word_of(method_words(), method) +
            "' is one of single cells.",
          "Set 'Scope = cell', or for the whole object 'Methods' "
          "to " +
            object_words() + '.');
    }
    /** Whether any row is of the consistent fit. */
    template <typename Row>
    bool
    any_consistent(const std::vector<Row> &rows)
    {
      return std::any_of(rows.begin(), rows.end(), [](const Row &row) {
        return row.method == Method::consistent;
      });
    }
  } // namespace

  template <int dim>
  FitSection<dim>::FitSection() : dealii::ParameterAcceptor("Fit")
  {
    add_parameter("Methods",
                  methods_word_,
                  "Fits, each a row of the tables: " +
                    join(words_of(method_words())) +
                    " (no unit). The first five approximate the cell's "
                    "stiffness: block and frobenius in the Frobenius norm, "
                    "spectral in the 2-norm, consistent what it does under "
                    "constant strain first, compliance its displacements "
                    "under loads. The others are published formulas.");
    add_parameter("Enrichment",
                  enrichments_word_,
                  "What a cell has besides springs between all pairs of its "
                  "vertices: " +
                    join(words_of(enrichment_words())) +
                    " (no unit). Of a list, each fit takes those that it has, "
                    "and each is a row of the tables. volume: a spring of the "
                    "cell's volume, in 2-d of its area; angles: springs of the "
                    "angles of its faces; coupling: terms between all its "
                    "lengths, with which it equals the finite element at rest. "
                    "Of the published formulas baudet and delingette have none "
                    "and coupling, golec has volume, the others none.");
    add_parameter("Spring law",
                  law_word_,
                  "The energy of springs and couplings away from rest: " +
                    join(words_of(spring_law_words()), " or ") +
                    " in the length (no unit). quadratic: k (l - L)^2 / 2. "
                    "biquadratic: k (l^2 - L^2)^2 / (8 L^2); with coupling it "
                    "makes triangles and tetrahedra St. Venant-Kirchhoff's "
                    "material. At rest both are the same.");
    add_parameter("Scope",
                  scope_word_,
                  "What a fit finds at once: the springs of a cell, or all "
                  "springs of the object (cell or object; no unit). For the "
                  "object there are " +
                    object_words() +
                    "; the time of compliance grows with the third power of "
                    "the number of springs.");
    add_parameter("Fields",
                  fields_word_,
                  "The loads under which the consistent fit of the whole "
                  "object gets the displacements right: " +
                    join(words_of(field_words())) +
                    " (no unit). affine, quadratic: forces of all nodes that "
                    "vary so with their place, whatever the scene, on the "
                    "object that nothing holds; responses: the loads of the "
                    "scene.");
    add_parameter("Nonnegative",
                  options_.nonnegative,
                  "Whether every spring must have a stiffness >= 0 (no unit). "
                  "Volumes, angles and couplings are free as long as the "
                  "cell releases energy in no deformation.");
    add_parameter("States",
                  states_text_,
                  "Homogeneous deformations in which the tangent of a cell "
                  "shall be near that of its finite element too, with the "
                  "'Material law' of section Response: " +
                    states_help() +
                    " (no unit). A stretch is a deformed length divided by "
                    "that at rest; the shear xy moves points along x, in "
                    "proportion to y. The fit frobenius minimises the sum over "
                    "them and the state at rest; others have no states.");
    add_parameter("Norm",
                  norm_word_,
                  "What the consistent fit of quadrilaterals and hexahedra "
                  "minimises once constant strains are right: " +
                    join(words_of(norm_words()), " or ") + " (no unit).");
    add_parameter("Engine",
                  engine_word_,
                  "What solves a fit in the spectral norm: " +
                    join(words_of(engine_words()), " or ") +
                    " (no unit). Both are certified alike.");
    add_parameter("Tolerance",
                  options_.tolerance,
                  "Duality gap that a spectral fit must certify, relative to "
                  "the spectral norm of the cell's stiffness (no unit), "
                  "positive.");
    parse_parameters_call_back.connect([this]() {
      options_.engine = value_of(engine_words(), engine_word_, "Fit/Engine");
      options_.norm   = value_of(norm_words(), norm_word_, "Fit/Norm");
      law_    = value_of(spring_law_words(), law_word_, "Fit/Spring law");
      scope_  = value_of(scope_words(), scope_word_, "Fit/Scope");
      states_ = parse_states(states_text_, dim, "Fit/States");
      check();
    });
  }

  template <int dim>
  Scope
  FitSection<dim>::scope() const
  {
    return scope_;
  }

  template <int dim>
  std::vector<Field>
  FitSection<dim>::fields() const
  {
    return values_of(field_words(), fields_word_, "Fit/Fields");
  }

  template <int dim>
  bool
  FitSection<dim>::needs_responses() const
  {
    if (scope_ != Scope::object)
      return false;
    const auto wanted = fields();
    return any_consistent(rows()) &&
           std::find(wanted.begin(), wanted.end(), Field::responses) !=
             wanted.end();
  }

  template <int dim>
  FitOptions
  FitSection<dim>::options(const Row &row) const
  {
    FitOptions options = options_;
    options.enrichment = row.enrichment;
    return options;
  }

  template <int dim>
  void
  FitSection<dim>::check() const
  {
    rows();
    fields();
    if (has_states() && scope_ == Scope::object)
      throw EntryError("Fit/States",
                       "the fits of the whole object have no states.",
                       "Set 'Scope = cell', or leave 'States' empty.");
    if (!(options_.tolerance > 0. && std::isfinite(options_.tolerance)))
      {
        std::ostringstream value;
        value << options_.tolerance;
        throw EntryError("Fit/Tolerance",
                         value.str() + " is not positive and finite.",
                         "Give a relative gap such as 1e-6.");
      }
  }

  template <int dim>
  SpringLaw
  FitSection<dim>::spring_law() const
  {
    return law_;
  }

  template <int dim>
  bool
  FitSection<dim>::has_states() const
  {
    return !states_.empty();
  }

  template <int dim>
  const std::vector<Eigen::MatrixXd> &
  FitSection<dim>::states() const
  {
    return states_;
  }

  template <int dim>
  void
  FitSection<dim>::check_states(const MaterialLaw law) const
  {
    if (has_states() && law == MaterialLaw::linear)
      throw EntryError("Fit/States",
                       "with the 'Material law' linear of section Response "
                       "the finite elements are the same in every state.",
                       "Set that to " + nonlinear_law_words() +
                         ", or leave 'States' empty.");
  }

  template <int dim>
  std::vector<typename FitSection<dim>::Row>
  FitSection<dim>::rows() const
  {
    const auto methods =
      values_of(method_words(), methods_word_, "Fit/Methods");
    const auto enrichments =
      values_of(enrichment_words(), enrichments_word_, "Fit/Enrichment");
    std::vector<Row> rows;
    for (const Method method : methods)
      {
        if (scope_ == Scope::object)
          check_object_scope(method);
        const auto &known   = enrichments_of(method);
        const auto n_rows   = rows.size();
        const auto is_known = [&](const Enrichment enrichment) {
          return std::find(known.begin(), known.end(), enrichment) !=
                 known.end();
        };
        for (const Enrichment enrichment : enrichments)
          if (is_known(enrichment))
            rows.push_back({method, enrichment});
        if (rows.size() == n_rows)
          {
            std::vector<std::string> words;
            for (const Enrichment enrichment : known)
              words.push_back(word_of(enrichment_words(), enrichment));
            const std::string fit = word_of(method_words(), method);
            throw EntryError("Fit/Enrichment",
                             "the fit '" + fit + "' does not have '" +
                               enrichments_word_ + "'.",
                             "It has: " + join(words) +
                               ". Add one to the list, or leave '" + fit +
                               "' out of 'Methods'.");
          }
      }
    return rows;
  }


  template <int dim>
  void
  FitSection<dim>::check_cells(const CellKind kind) const
  {
    const auto suits = [](const Method method, const CellKind cells) {
      const auto &known = cells_of(method);
      return std::find(known.begin(), known.end(), cells) != known.end();
    };
    for (const auto &row : rows())
      if (!suits(row.method, kind))
        {
          std::vector<std::string> fits, cells;
          for (const auto &[method, word] : method_words())
            if (suits(method, kind))
              fits.push_back(word);
          for (const CellKind known : cells_of(row.method))
            cells.push_back(word_of(cell_kind_words(), known));
          const std::string mesh_cells = word_of(cell_kind_words(), kind);
          throw EntryError("Fit/Methods",
                           "'" + word_of(method_words(), row.method) +
                             "' is not published for " + mesh_cells +
                             ", of which the mesh is made, but for " +
                             join(cells) + '.',
                           "For " + mesh_cells + " there are: " + join(fits) +
                             '.');
        }

    if (has_states())
      for (const auto &row : rows())
        if (!springfit::has_states(row.method, row.enrichment, kind))
          throw EntryError("Fit/States",
                           "the fit '" + word_of(method_words(), row.method) +
                             "' of " + word_of(cell_kind_words(), kind) +
                             " with the enrichment '" +
                             word_of(enrichment_words(), row.enrichment) +
                             "' has no states.",
                           "Leave 'States' empty, or ask for frobenius only, "
                           "with coupling on triangles and tetrahedra only.");
  }

  template <int dim>
  std::vector<std::string>
  FitSection<dim>::unused_entries(const CellKind kind) const
  {
    const bool has_consistent = any_consistent(rows());
    std::vector<std::string> sentences;
    if (options_.norm == Norm::spectral &&
        (!has_consistent || scope_ == Scope::object || is_simplex(kind)))
      sentences.push_back("Fit/Norm is not used: it is of the fit 'consistent' "
                          "of single quadrilaterals and hexahedra.");
    if (fields() != std::vector<Field>{Field::responses} &&
        (!has_consistent || scope_ == Scope::cell))
      sentences.push_back("Fit/Fields is not used: it is of the fit "
                          "'consistent' with 'Scope = object'.");
    return sentences;
  }

  template class FitSection<2>;
  template class FitSection<3>;
} // namespace springfit
