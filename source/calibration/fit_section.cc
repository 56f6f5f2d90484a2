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
      for (const auto &[method, word] : method_words())
        if (method->fit_object)
          words.push_back(word);
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
    check_object_scope(const Method &method)
    {
      if (!method.fit_object)
        throw EntryError(
          "Fit/Scope",
          "the fit '" + method.word + "' is one of single cells.",
          "Set 'Scope = cell', or for the whole object 'Methods' "
          "to " +
            object_words() + '.');
    }

    /** Whether the fit of any row has it. */
    template <typename Row>
    bool
    any_has(const std::vector<Row> &rows, const Feature feature)
    {
      return std::any_of(rows.begin(), rows.end(), [&](const Row &row) {
        return has(*row.method, feature);
      });
    }

    template <typename Row>
    bool
    all_have(const std::vector<Row> &rows, const Feature feature)
    {
      return std::all_of(rows.begin(), rows.end(), [&](const Row &row) {
        return has(*row.method, feature);
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
                    "under loads. stable neo-hookean is the finite element "
                    "itself: springs under tension, volumes under pressure. "
                    "The others are published formulas.");
    add_parameter(
      "Enrichment",
      enrichments_word_,
      "What a cell has besides springs between all pairs of its "
      "vertices: " +
        join(words_of(enrichment_words())) +
        " (no unit). Each fit uses those of the list that it has, "
        "and each is a row of the tables. volume: a spring of the "
        "cell's volume, in 2-d of its area; point volumes: one at "
        "each point of the finite element's quadrature, which on "
        "triangles and tetrahedra is the volume; angles: springs of the "
        "angles of its faces; coupling: terms between all its "
        "lengths, with which it equals the finite element at rest. "
        "stable neo-hookean has volume and point volumes. Of the "
        "published formulas baudet and delingette have none and "
        "coupling, golec has volume, the others none.");
    add_parameter("Spring law",
                  law_word_,
                  "The energy of springs and couplings away from rest: " +
                    join(words_of(spring_law_words()), " or ") +
                    " in the length (no unit). quadratic: k (l - L)^2 / 2. "
                    "biquadratic: k (l^2 - L^2)^2 / (8 L^2); with coupling it "
                    "makes triangles and tetrahedra St. Venant-Kirchhoff's "
                    "material. At rest both are the same.");
    add_parameter("Volume law",
                  volume_law_word_,
                  "The energy of the volumes under pressure of stable "
                  "neo-hookean: " +
                    join(words_of(volume_law_words()), " or ") +
                    " (no unit). quadratic in the volume, which is the "
                    "'Material law' stable neo-hookean of section Response "
                    "and lets cells turn inside out; logarithmic is its law "
                    "neo-hookean, which does not.");
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
      options_.volume_law =
        value_of(volume_law_words(), volume_law_word_, "Fit/Volume law");
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
  FitSection<dim>::needs_responses(const Row &row) const
  {
    const auto wanted = fields();
    return scope_ == Scope::object && has(*row.method, Feature::fields) &&
           std::find(wanted.begin(), wanted.end(), Field::responses) !=
             wanted.end();
  }

  template <int dim>
  bool
  FitSection<dim>::needs_responses() const
  {
    const auto all = rows();
    return std::any_of(all.begin(), all.end(), [this](const Row &row) {
      return needs_responses(row);
    });
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
    for (const Method *method : methods)
      {
        if (scope_ == Scope::object)
          check_object_scope(*method);
        const auto n_rows = rows.size();
        for (const Enrichment enrichment : enrichments)
          if (suits(*method, enrichment))
            rows.push_back({method, enrichment});
        if (rows.size() == n_rows)
          {
            std::vector<std::string> words;
            for (const Enrichment enrichment : method->enrichments)
              words.push_back(word_of(enrichment_words(), enrichment));
            const std::string &fit = method->word;
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
  std::vector<typename FitSection<dim>::Row>
  FitSection<dim>::rows(const CellKind kind) const
  {
    std::vector<Row> distinct;
    for (Row row : rows())
      {
        if (is_simplex(kind) && row.enrichment == Enrichment::point_volumes)
          row.enrichment = Enrichment::volume;
        if (std::none_of(distinct.begin(), distinct.end(), [&](const Row &r) {
              return r.method == row.method && r.enrichment == row.enrichment;
            }))
          distinct.push_back(row);
      }
    return distinct;
  }


  template <int dim>
  void
  FitSection<dim>::check_cells(const CellKind kind) const
  {
    for (const auto &row : rows())
      if (!suits(*row.method, kind))
        {
          std::vector<std::string> fits, cells;
          for (const auto &[method, word] : method_words())
            if (suits(*method, kind))
              fits.push_back(word);
          for (const CellKind known : row.method->cells)
            cells.push_back(word_of(cell_kind_words(), known));
          const std::string mesh_cells = word_of(cell_kind_words(), kind);
          throw EntryError(
            "Fit/Methods",
            "'" + row.method->word + "' is not published for " + mesh_cells +
              ", of which the mesh is made, but for " + join(cells) + '.',
            "For " + mesh_cells + " there are: " + join(fits) + '.');
        }

    if (has_states())
      for (const auto &row : rows())
        if (!springfit::has_states(*row.method, row.enrichment, kind))
          throw EntryError("Fit/States",
                           "the fit '" + row.method->word + "' of " +
                             word_of(cell_kind_words(), kind) +
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
    std::vector<std::string> sentences;
    if (options_.volume_law != VolumeLaw::quadratic &&
        !any_has(rows(), Feature::finite_element))
      sentences.push_back("Fit/Volume law is not used: it is of the fit "
                          "'stable neo-hookean'.");
    if (law_ != SpringLaw::quadratic &&
        all_have(rows(), Feature::finite_element))
      sentences.push_back("Fit/Spring law is not used: the springs of 'stable "
                          "neo-hookean' have no length at rest.");
    if (options_.norm == Norm::spectral &&
        (!any_has(rows(), Feature::norm) || scope_ == Scope::object ||
         is_simplex(kind)))
      sentences.push_back("Fit/Norm is not used: it is of the fit 'consistent' "
                          "of single quadrilaterals and hexahedra.");
    if (fields() != std::vector<Field>{Field::responses} &&
        (!any_has(rows(), Feature::fields) || scope_ == Scope::cell))
      sentences.push_back("Fit/Fields is not used: it is of the fit "
                          "'consistent' with 'Scope = object'.");
    return sentences;
  }

  template class FitSection<2>;
  template class FitSection<3>;
} // namespace springfit
