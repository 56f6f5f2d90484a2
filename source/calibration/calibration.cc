#include <springfit/calibration/calibration.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/calibration/shape_quality.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/progress.h>
#include <springfit/core/words.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/springs/volume.h>

#include <deal.II/base/mpi.h>
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
    template <int dim>
    using CellIterator =
      typename dealii::Triangulation<dim>::active_cell_iterator;

    template <int dim>
    std::vector<CellIterator<dim>>
    cells_by_index(const Mesh<dim> &mesh)
    {
      std::vector<CellIterator<dim>> cells;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        cells.push_back(cell);
      return cells;
    }

    /** A distinct cell as an error names it. */
    template <int dim>
    std::string
    description(const CellIterator<dim> &cell, const CellKind kind)
    {
      std::ostringstream text;
      text.precision(3);
      text << singular(kind) << ' ' << cell->active_cell_index() << " (centre "
           << cell->center() << " m, shape quality "
           << shape_quality(cell_points<dim>(cell), kind) << " of 1)";
      return text.str();
    }

    /** One fit as a plain row of numbers, which ranks can exchange. */
    struct TimedFit
    {
      FitResult result;
      double seconds;
    };

    std::vector<double>
    pack(const TimedFit &fit)
    {
      const FitResult &result     = fit.result;
      std::vector<double> numbers = {fit.seconds,
                                     result.frobenius_residual,
                                     result.spectral_residual,
                                     result.duality_gap.value_or(-1.),
                                     static_cast<double>(result.n_negative),
                                     static_cast<double>(
                                       result.volume_stiffness.has_value()),
                                     result.volume_stiffness.value_or(0.),
                                     static_cast<double>(result.k.size())};
      numbers.insert(numbers.end(),
                     result.k.data(),
                     result.k.data() + result.k.size());
      for (const auto &[a, b, stiffness] : result.couplings)
        numbers.insert(numbers.end(),
                       {static_cast<double>(a),
                        static_cast<double>(b),
                        stiffness});
      return numbers;
    }

    TimedFit
    unpack(const std::vector<double> &numbers)
    {
      TimedFit fit;
      FitResult &result         = fit.result;
      fit.seconds               = numbers[0];
      result.frobenius_residual = numbers[1];
      result.spectral_residual  = numbers[2];
      if (numbers[3] >= 0.)
        result.duality_gap = numbers[3];
      result.n_negative = static_cast<unsigned int>(numbers[4]);
      if (numbers[5] != 0.)
        result.volume_stiffness = numbers[6];
      const auto n_springs = static_cast<std::size_t>(numbers[7]);
      result.k =
        Eigen::Map<const Eigen::VectorXd>(numbers.data() + 8, n_springs);
      for (std::size_t c = 8 + n_springs; c < numbers.size(); c += 3)
        result.couplings.push_back({static_cast<unsigned int>(numbers[c]),
                                    static_cast<unsigned int>(numbers[c + 1]),
                                    numbers[c + 2]});
      return fit;
    }

    /**
     * @throws RunError when the certificate does not hold what the user asks
     * for, or the constants are not finite.
     */
    template <int dim>
    void
    check_result(const FitResult &result,
                 const FitOptions &options,
                 const std::string &fit_name,
                 const CellIterator<dim> &cell,
                 const CellKind kind)
    {
      if (!all_finite(result))
        throw RunError("The fit '" + fit_name + "' of " +
                         description<dim>(cell, kind) +
                         " gave constants that are not finite.",
                       "Improve the mesh there.");
      if (result.duality_gap && !(*result.duality_gap <= options.tolerance))
        {
          std::ostringstream text;
          text << "The fit '" << fit_name << "' of "
               << description<dim>(cell, kind) << " has a certified gap of "
               << *result.duality_gap << ", more than 'Tolerance' "
               << options.tolerance << '.';
          throw RunError(text.str(),
                         "Improve the mesh there, raise 'Tolerance' in section "
                         "Fit, or choose another 'Engine'.");
        }
    }

    template <int dim>
    IsotropicMaterial
    material_of(const CellMaterial &material)
    {
      return isotropic_material(dim,
                                material.lame.lambda,
                                material.lame.mu,
                                material.thickness);
    }

    /** How many cells do not meet each assumption of a published method. */
    template <int dim>
    std::map<std::string, unsigned int>
    count_unmet_assumptions(const DistinctCells &cells,
                            const std::vector<CellIterator<dim>> &iterators,
                            const CellKind kind,
                            const MaterialTable &materials,
                            const Method method)
    {
      std::map<std::string, unsigned int> counts;
      for (const auto &distinct : cells.distinct)
        for (const auto &assumption : unmet_assumptions(
               method,
               cell_points<dim>(iterators[distinct.representative]),
               kind,
               material_of<dim>(materials.at(distinct.material))))
          counts[assumption] += distinct.multiplicity;
      return counts;
    }

    /** Fit every distinct cell; the ranks share the work evenly. */
    template <int dim>
    std::vector<TimedFit>
    fit_distinct(const DistinctCells &cells,
                 const std::vector<CellIterator<dim>> &iterators,
                 const CellKind kind,
                 const Element<dim> &element,
                 const MaterialTable &materials,
                 const Method method,
                 const FitOptions &options,
                 const std::string &name,
                 Session &session)
    {
      const auto communicator = session.communicator();
      const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(communicator);
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(communicator);

      std::map<unsigned int, std::vector<double>> mine;
      run_collectively(communicator, [&]() {
        CellMatrices<dim> cell_matrices(element);
        Progress progress("Fits (" + name + ") of distinct cells",
                          (cells.distinct.size() + n_ranks - 1) / n_ranks,
                          rank == 0);
        for (unsigned int c = rank; c < cells.distinct.size(); c += n_ranks)
          {
            const auto &distinct = cells.distinct[c];
            const auto &cell     = iterators[distinct.representative];
            const auto &material = materials.at(distinct.material);
            const auto start     = std::chrono::steady_clock::now();
            const auto problem =
              cell_problem<dim>(cell, kind, cell_matrices, material);
            FitResult result;
            try
              {
                result = fit(problem, method, options);
              }
            catch (const RunError &error)
              {
                throw RunError("The fit '" + name + "' of " +
                                 description<dim>(cell, kind) + " failed.",
                               error.what());
              }
            check_result<dim>(result, options, name, cell, kind);
            const std::chrono::duration<double> seconds =
              std::chrono::steady_clock::now() - start;
            mine[c] = pack({result, seconds.count()});
            progress.step();
          }
      });

      std::vector<TimedFit> fits(cells.distinct.size());
      for (const auto &of_rank :
           dealii::Utilities::MPI::all_gather(communicator, mine))
        for (const auto &[c, numbers] : of_rank)
          fits[c] = unpack(numbers);
      return fits;
    }

    template <int dim>
    SpringNetwork
    assemble_network(const Mesh<dim> &mesh,
                     const DistinctCells &cells,
                     const std::vector<CellIterator<dim>> &iterators,
                     const std::vector<TimedFit> &fits,
                     const Element<dim> &element,
                     const MaterialTable &materials)
    {
      const auto &vertices = mesh.triangulation.get_vertices();
      Eigen::MatrixXd nodes(dim, vertices.size());
      for (unsigned int v = 0; v < vertices.size(); ++v)
        for (int d = 0; d < dim; ++d)
          nodes(d, v) = vertices[v][d];

      NetworkBuilder builder(nodes);
      CellMatrices<dim> cell_matrices(element);
      std::vector<unsigned int> cell_nodes;
      for (unsigned int c = 0; c < iterators.size(); ++c)
        {
          const auto &copy       = cells.copies[c];
          const CellModel &model = fits[copy.distinct].result;
          const auto &pairs      = node_pairs(mesh.cell_kind);
          // Stiffness is as the length to the power dim - 2. The tangent of a
          // volume spring is its constant times the gradient's square, which
          // is as the power 2 (dim - 1).
          const double factor = std::pow(copy.scale, dim - 2);
          builder.add_springs(copy.nodes, pairs, factor * model.k);

          std::vector<LengthCoupling> couplings = model.couplings;
          for (auto &coupling : couplings)
            coupling.stiffness *= factor;
          builder.add_couplings(copy.nodes, pairs, couplings);

          cell_nodes.clear();
          for (const unsigned int v : iterators[c]->vertex_indices())
            cell_nodes.push_back(iterators[c]->vertex_index(v));
          // With the cell's own numbering, in which the volume is positive;
          // a mirrored copy in that of the representative has a negative one.
          if (model.volume_stiffness)
            builder.add_volume(cell_nodes,
                               std::pow(copy.scale, -dim) *
                                 *model.volume_stiffness,
                               volume(cell_points<dim>(iterators[c]),
                                      mesh.cell_kind));
          builder.add_masses(
            cell_nodes,
            cell_matrices.masses(iterators[c],
                                 materials.at(iterators[c]->material_id())));
        }
      return builder.build();
    }
  } // namespace

  template <int dim>
  FitProblem
  cell_problem(
    const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
    const CellKind kind,
    CellMatrices<dim> &cell_matrices,
    const CellMaterial &material)
  {
    return make_fit_problem(cell_points<dim>(cell),
                            kind,
                            cell_matrices.stiffness(cell, material),
                            material_of<dim>(material));
  }

  template <int dim>
  Calibration<dim>::Calibration() : dealii::ParameterAcceptor("Fit")
  {
    add_parameter("Methods",
                  methods_word_,
                  "Fits, each a row of the tables: " +
                    join(words_of(method_words())) +
                    " (no unit). The first three approximate the cell's "
                    "stiffness; the others are published formulas.");
    add_parameter("Enrichment",
                  enrichments_word_,
                  "What a cell has besides springs between all pairs of its "
                  "vertices: " +
                    join(words_of(enrichment_words())) +
                    " (no unit). Of a list, each fit takes those that it has, "
                    "and each is a row of the tables: baudet and delingette "
                    "have none and coupling, golec has volume, the others "
                    "none.");
    add_parameter("Nonnegative",
                  options_.nonnegative,
                  "Whether every spring of a cell must have a stiffness >= 0 "
                  "(no unit).");
    add_parameter("Engine",
                  engine_word_,
                  "What solves the spectral fit: " +
                    join(words_of(engine_words()), " or ") +
                    " (no unit). Both are certified alike.");
    add_parameter("Tolerance",
                  options_.tolerance,
                  "Duality gap that a spectral fit must certify, relative to "
                  "the spectral norm of the cell's stiffness (no unit), "
                  "positive.");
    parse_parameters_call_back.connect([this]() {
      options_.engine = value_of(engine_words(), engine_word_, "Fit/Engine");
      check();
    });
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
  }


  template <int dim>
  std::vector<CalibratedNetwork>
  Calibration<dim>::calibrate(const Mesh<dim> &mesh,
                              const Element<dim> &element,
                              const MaterialTable &materials,
                              Session &session) const
  {
    dealii::Timer search_timer(session.communicator());
    const auto cells     = find_distinct_cells(mesh);
    const auto iterators = cells_by_index(mesh);
    search_timer.stop();

    check_cells(mesh.cell_kind);
    std::set<Method> warned;
    std::vector<CalibratedNetwork> networks;
    for (const auto &[method, enrichment] : rows())
      {
        CalibratedNetwork network;
        network.fit        = word_of(method_words(), method);
        network.enrichment = word_of(enrichment_words(), enrichment);
        network.name       = enrichment == Enrichment::none
                               ? network.fit
                               : network.fit + '_' + network.enrichment;

        if (warned.insert(method).second)
          for (const auto &[assumption, n_cells] : count_unmet_assumptions<dim>(
                 cells, iterators, mesh.cell_kind, materials, method))
            session.warn("The constants of '" + network.fit +
                         "' are published for " + assumption + ", which " +
                         std::to_string(n_cells) + " of " +
                         std::to_string(iterators.size()) +
                         " cells do not meet. They are used all the same.");

        dealii::TimerOutput::Scope scope(session.timer(),
                                         "Calibration, " + network.name);
        dealii::Timer timer(session.communicator());
        const auto fits = fit_distinct(cells,
                                       iterators,
                                       mesh.cell_kind,
                                       element,
                                       materials,
                                       method,
                                       options({method, enrichment}),
                                       network.name,
                                       session);
        network.network =
          assemble_network(mesh, cells, iterators, fits, element, materials);
        for (unsigned int c = 0; c < fits.size(); ++c)
          network.cells.push_back({cells.distinct[c].representative,
                                   cells.distinct[c].multiplicity,
                                   fits[c].result,
                                   fits[c].seconds});
        timer.stop();
        network.seconds = search_timer.wall_time() + timer.wall_time();

        const unsigned int n = n_negative(network.network);
        if (options_.nonnegative && is_published(method) && n > 0)
          session.warn("Of the springs of '" + network.name + "' " +
                       std::to_string(n) +
                       " are negative: 'Nonnegative' does not change the "
                       "constants of a published fit.");
        networks.push_back(std::move(network));
      }
    return networks;
  }

  template FitProblem
  cell_problem<2>(const dealii::Triangulation<2>::active_cell_iterator &,
                  CellKind,
                  CellMatrices<2> &,
                  const CellMaterial &);
  template FitProblem
  cell_problem<3>(const dealii::Triangulation<3>::active_cell_iterator &,
                  CellKind,
                  CellMatrices<3> &,
                  const CellMaterial &);
  template class Calibration<2>;
  template class Calibration<3>;
} // namespace springfit
