#include <springfit/calibration/calibration.h>
#include <springfit/calibration/cell_network.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/calibration/states.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/words.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
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
    object_enrichment_words()
    {
      std::vector<std::string> words;
      for (const Enrichment enrichment : object_enrichments())
        words.push_back(word_of(enrichment_words(), enrichment));
      return join(words);
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

    /** How many cells do not meet each assumption of a published method. */
    template <int dim>
    std::map<std::string, unsigned int>
    count_unmet_assumptions(const DistinctCells &cells,
                            const Mesh<dim> &mesh,
                            const MaterialTable &materials,
                            const Method method)
    {
      const auto iterators = cells_by_index(mesh);
      std::map<std::string, unsigned int> counts;
      for (const auto &distinct : cells.distinct)
        for (const auto &assumption : unmet_assumptions(
               method,
               cell_points<dim>(iterators[distinct.representative]),
               mesh.cell_kind,
               material_of<dim>(materials.at(distinct.material))))
          counts[assumption] += distinct.multiplicity;
      return counts;
    }

    std::vector<CellModel>
    models_of(const std::vector<TimedFit> &fits)
    {
      std::vector<CellModel> models;
      for (const auto &fit : fits)
        models.push_back(fit.result);
      return models;
    }

    /** Of springs alone the loaded object is checked as a whole. */
    void
    warn_of_indefinite_cells(const std::vector<TimedFit> &fits,
                             const std::string &name,
                             Session &session)
    {
      constexpr double rounding = 1e-10;
      const auto is_indefinite  = [](const TimedFit &fit) {
        return fit.result.smallest_eigenvalue.value_or(0.) < -rounding;
      };
      const auto n = std::count_if(fits.begin(), fits.end(), is_indefinite);
      if (n > 0)
        session.warn("The forces of '" + name +
                     "' release energy in some "
                     "deformation of " +
                     std::to_string(n) + " of " + std::to_string(fits.size()) +
                     " distinct cells: smallest_eigenvalue in fit.csv is "
                     "negative there. 'Nonnegative = true' in section Fit "
                     "keeps approximations of the stiffness from that.");
    }
  } // namespace

  template <int dim>
  Calibration<dim>::Calibration() : dealii::ParameterAcceptor("Fit")
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
                    object_words() + ", with the enrichments " +
                    object_enrichment_words() +
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
  Calibration<dim>::scope() const
  {
    return scope_;
  }

  template <int dim>
  std::vector<Field>
  Calibration<dim>::fields() const
  {
    return values_of(field_words(), fields_word_, "Fit/Fields");
  }

  template <int dim>
  bool
  Calibration<dim>::needs_responses() const
  {
    if (scope_ != Scope::object)
      return false;
    const auto all = rows();
    const bool is_needed =
      std::any_of(all.begin(), all.end(), [](const Row &row) {
        return row.method == Method::consistent;
      });
    const auto wanted = fields();
    return is_needed &&
           std::find(wanted.begin(), wanted.end(), Field::responses) !=
             wanted.end();
  }

  template <int dim>
  FitOptions
  Calibration<dim>::options(const Row &row) const
  {
    FitOptions options = options_;
    options.enrichment = row.enrichment;
    return options;
  }

  template <int dim>
  void
  Calibration<dim>::check() const
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
  bool
  Calibration<dim>::has_states() const
  {
    return !states_.empty();
  }

  template <int dim>
  void
  Calibration<dim>::check_states(const MaterialLaw law) const
  {
    if (has_states() && law == MaterialLaw::linear)
      throw EntryError(
        "Fit/States",
        "with the 'Material law' linear of section Response "
        "the finite elements are the same in every state.",
        "Set that to " +
          join({word_of(material_law_words(), MaterialLaw::st_venant_kirchhoff),
                word_of(material_law_words(), MaterialLaw::neo_hookean)},
               " or ") +
          ", or leave 'States' empty.");
  }

  template <int dim>
  std::vector<typename Calibration<dim>::Row>
  Calibration<dim>::rows() const
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
        const auto &known   = scope_ == Scope::object ? object_enrichments()
                                                      : enrichments_of(method);
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
  Calibration<dim>::check_cells(const CellKind kind) const
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
  std::vector<CalibratedNetwork>
  Calibration<dim>::calibrate(const Mesh<dim> &mesh,
                              const Element<dim> &element,
                              const MaterialTable &materials,
                              const Eigen::MatrixXd &responses,
                              const MaterialLaw law,
                              Session &session) const
  {
    check_cells(mesh.cell_kind);
    check_states(law);
    const auto cells = distinct_cells(mesh);
    warn_of_assumptions(cells, mesh, materials, session);

    std::vector<CalibratedNetwork> networks;
    for (const auto &row : rows())
      {
        CalibratedNetwork network;
        network.scope      = scope_;
        network.fit        = word_of(method_words(), row.method);
        network.enrichment = word_of(enrichment_words(), row.enrichment);
        network.name       = row.enrichment == Enrichment::none
                               ? network.fit
                               : network.fit + '_' + network.enrichment;

        dealii::TimerOutput::Scope scope(session.timer(),
                                         "Calibration, " + network.name);
        dealii::Timer timer(session.communicator());
        if (scope_ == Scope::object)
          calibrate_object(
            cells, mesh, element, materials, responses, row, network, session);
        else
          calibrate_cells(cells,
                          mesh,
                          element,
                          materials,
                          {states_, law, law_},
                          row,
                          network,
                          session);
        network.network.law = law_;
        network.seconds     = timer.wall_time();
        networks.push_back(std::move(network));
      }
    return networks;
  }

  template <int dim>
  DistinctCells
  Calibration<dim>::distinct_cells(const Mesh<dim> &mesh) const
  {
    if (scope_ == Scope::object)
      return every_cell(mesh);
    // States are given in the scene's directions.
    return has_states() ? find_distinct_oriented_cells(mesh)
                        : find_distinct_cells(mesh);
  }

  template <int dim>
  void
  Calibration<dim>::warn_of_assumptions(const DistinctCells &cells,
                                        const Mesh<dim> &mesh,
                                        const MaterialTable &materials,
                                        Session &session) const
  {
    std::set<Method> methods;
    for (const auto &row : rows())
      if (methods.insert(row.method).second)
        for (const auto &[assumption, n_cells] :
             count_unmet_assumptions<dim>(cells, mesh, materials, row.method))
          session.warn("The constants of '" +
                       word_of(method_words(), row.method) +
                       "' are published for " + assumption + ", which " +
                       std::to_string(n_cells) + " of " +
                       std::to_string(cells.copies.size()) +
                       " cells do not meet. They are used all the same.");
  }

  template <int dim>
  void
  Calibration<dim>::calibrate_cells(const DistinctCells &cells,
                                    const Mesh<dim> &mesh,
                                    const Element<dim> &element,
                                    const MaterialTable &materials,
                                    const ReferenceStates &states,
                                    const Row &row,
                                    CalibratedNetwork &network,
                                    Session &session) const
  {
    const auto fits = fit_distinct_cells(cells,
                                         mesh,
                                         element,
                                         materials,
                                         row.method,
                                         options(row),
                                         states,
                                         network.name,
                                         session);
    for (unsigned int c = 0; c < fits.size(); ++c)
      network.cells.push_back({cells.distinct[c].representative,
                               cells.distinct[c].multiplicity,
                               fits[c].result,
                               fits[c].seconds});
    network.network =
      assemble_network(mesh, cells, models_of(fits), element, materials);

    if (row.enrichment != Enrichment::none)
      warn_of_indefinite_cells(fits, network.name, session);
    const unsigned int n = n_negative(network.network);
    if (options_.nonnegative && is_published(row.method) && n > 0)
      session.warn("Of the springs of '" + network.name + "' " +
                   std::to_string(n) +
                   " are negative: 'Nonnegative' does not change the "
                   "constants of a published fit.");
  }

  template <int dim>
  void
  Calibration<dim>::calibrate_object(const DistinctCells &cells,
                                     const Mesh<dim> &mesh,
                                     const Element<dim> &element,
                                     const MaterialTable &materials,
                                     const Eigen::MatrixXd &responses,
                                     const Row &row,
                                     CalibratedNetwork &network,
                                     Session &session) const
  {
    // What the mesh has, with constants of one.
    const std::vector<CellModel> units(cells.distinct.size(),
                                       unit_model(mesh.cell_kind,
                                                  row.enrichment));
    const auto unit_network =
      assemble_network(mesh, cells, units, element, materials);

    // Of the consistent fit: the same fit of the cells.
    Eigen::VectorXd prior;
    if (row.method == Method::consistent)
      {
        const auto fits = fit_distinct_cells<dim>(cells,
                                                  mesh,
                                                  element,
                                                  materials,
                                                  row.method,
                                                  options(row),
                                                  {},
                                                  network.name,
                                                  session);
        prior           = constants_of(
          assemble_network(mesh, cells, models_of(fits), element, materials));
      }

    // The same on every rank: a factorisation is not worth distributing.
    const auto start = std::chrono::steady_clock::now();
    ObjectFit found;
    run_collectively(session.communicator(), [&]() {
      auto problem =
        make_object_problem<dim>(unit_network,
                                 object_stiffness(mesh, element, materials),
                                 options_.nonnegative);
      const auto all_fields = displacement_fields(fields(), problem, responses);
      found = fit_object(problem, row.method, all_fields, prior);
      if (found.n_unstable > 0 && options_.nonnegative &&
          row.enrichment != Enrichment::coupling)
        {
          // Volumes or angles so negative that the object gives way. Where
          // these, too, are >= 0 it cannot.
          problem.nonnegative.assign(problem.terms.size(), true);
          found = fit_object(problem, row.method, all_fields, prior);
        }
    });
    const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
    network.network = with_constants(unit_network, found.constants);

    FitResult result{};
    result.frobenius_residual = found.frobenius_residual;
    result.spectral_residual  = found.spectral_residual;
    result.n_negative         = n_negative(network.network);
    network.cells             = {{0, 1, result, seconds.count()}};
    if (found.n_unstable > 0)
      session.warn("The springs of the fit '" + network.name +
                   "' are unstable where nothing holds them: " +
                   std::to_string(found.n_unstable) +
                   " of their deformations release energy." +
                   (options_.nonnegative
                      ? ""
                      : " Set 'Nonnegative = true' in section Fit."));
  }

  template class Calibration<2>;
  template class Calibration<3>;
} // namespace springfit
