#include <springfit/calibration/calibration.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/calibration/shape_quality.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/progress.h>
#include <springfit/core/words.h>
#include <springfit/reference/cell_matrices.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <sstream>

namespace springfit
{
  namespace
  {
    const WordTable<Enrichment> &
    enrichment_words()
    {
      static const WordTable<Enrichment> table = {{Enrichment::none, "none"}};
      return table;
    }

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
      std::vector<double> numbers = {fit.seconds,
                                     fit.result.frobenius_residual,
                                     fit.result.spectral_residual,
                                     fit.result.duality_gap.value_or(-1.),
                                     static_cast<double>(
                                       fit.result.n_negative)};
      numbers.insert(numbers.end(),
                     fit.result.k.data(),
                     fit.result.k.data() + fit.result.k.size());
      return numbers;
    }

    TimedFit
    unpack(const std::vector<double> &numbers)
    {
      TimedFit fit;
      fit.seconds                   = numbers[0];
      fit.result.frobenius_residual = numbers[1];
      fit.result.spectral_residual  = numbers[2];
      if (numbers[3] >= 0.)
        fit.result.duality_gap = numbers[3];
      fit.result.n_negative = static_cast<unsigned int>(numbers[4]);
      fit.result.k = Eigen::Map<const Eigen::VectorXd>(numbers.data() + 5,
                                                       numbers.size() - 5);
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
      if (!result.k.allFinite())
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
                 Session &session)
    {
      const auto communicator = session.communicator();
      const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(communicator);
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(communicator);
      const std::string name = word_of(method_words(), method);

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
            const auto start     = std::chrono::steady_clock::now();
            const auto problem   = make_fit_problem(
              cell_points<dim>(cell),
              kind,
              cell_matrices.stiffness(cell, materials.at(distinct.material)));
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
          const auto &copy = cells.copies[c];
          builder.add_springs(copy.nodes,
                              node_pairs(mesh.cell_kind),
                              std::pow(copy.scale, dim - 2) *
                                fits[copy.distinct].result.k);
          cell_nodes.clear();
          for (const unsigned int v : iterators[c]->vertex_indices())
            cell_nodes.push_back(iterators[c]->vertex_index(v));
          builder.add_masses(
            cell_nodes,
            cell_matrices.masses(iterators[c],
                                 materials.at(iterators[c]->material_id())));
        }
      return builder.build();
    }
  } // namespace

  template <int dim>
  Calibration<dim>::Calibration() : dealii::ParameterAcceptor("Fit")
  {
    add_parameter("Methods",
                  methods_word_,
                  "Fits, each a row of the tables: " +
                    join(words_of(method_words())) + " (no unit).");
    add_parameter("Enrichment",
                  enrichment_word_,
                  "What a cell has besides springs between all pairs of its "
                  "vertices: " +
                    join(words_of(enrichment_words()), " or ") + " (no unit).");
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
  void
  Calibration<dim>::check() const
  {
    values_of(method_words(), methods_word_, "Fit/Methods");
    value_of(enrichment_words(), enrichment_word_, "Fit/Enrichment");
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

    std::vector<CalibratedNetwork> networks;
    for (const Method method :
         values_of(method_words(), methods_word_, "Fit/Methods"))
      {
        const std::string word = word_of(method_words(), method);
        dealii::TimerOutput::Scope scope(session.timer(),
                                         "Calibration, " + word);
        dealii::Timer timer(session.communicator());

        const auto fits = fit_distinct(cells,
                                       iterators,
                                       mesh.cell_kind,
                                       element,
                                       materials,
                                       method,
                                       options_,
                                       session);
        CalibratedNetwork network;
        network.fit        = word;
        network.enrichment = enrichment_word_;
        network.network =
          assemble_network(mesh, cells, iterators, fits, element, materials);
        for (unsigned int c = 0; c < fits.size(); ++c)
          network.cells.push_back({cells.distinct[c].representative,
                                   cells.distinct[c].multiplicity,
                                   fits[c].result,
                                   fits[c].seconds});
        timer.stop();
        network.seconds = search_timer.wall_time() + timer.wall_time();
        networks.push_back(std::move(network));
      }
    return networks;
  }

  template class Calibration<2>;
  template class Calibration<3>;
} // namespace springfit
