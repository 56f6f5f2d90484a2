#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/formatted.h>
#include <springfit/core/progress.h>
#include <springfit/core/version.h>
#include <springfit/output/gnuplot.h>
#include <springfit/output/growing_table.h>
#include <springfit/output/stability_page.h>
#include <springfit/output/stability_table.h>
#include <springfit/studies/stability_judge.h>
#include <springfit/studies/study.h>

#include <deal.II/base/mpi.h>

#include <boost/functional/hash.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    const std::string table_name = "stability.csv";
    const std::string mark_name  = "stability.unfinished";

    std::string
    contents_of(const std::filesystem::path &file)
    {
      std::ostringstream text;
      text << std::ifstream(file).rdbuf();
      return text.str();
    }

    /**
     * The rows that a stopped run of the same scene has left in the output
     * folder, by their keys.
     */
    std::map<std::string, StabilityRow>
    rows_of_stopped_run(const Session &session,
                        const std::string &mark,
                        const std::vector<std::string> &axes)
    {
      const auto &folder = session.output_directory();
      std::map<std::string, StabilityRow> rows;
      if (!std::filesystem::exists(folder / mark_name) ||
          contents_of(folder / mark_name) != mark ||
          contents_of(folder / "used.prm") !=
            contents_of(session.draft() / "used.prm"))
        return rows;
      std::ifstream table(folder / table_name);
      std::string line;
      std::getline(table, line);
      if (line != stability_header(axes))
        return rows;
      // A line without an end is one in hand.
      while (std::getline(table, line) && !table.eof())
        if (const auto row = parse_row(line, axes))
          rows.emplace(key_of(*row), *row);
      return rows;
    }

    /** What a run goes on from: the program, the scene and its mesh. */
    template <int dim, int spacedim>
    std::string
    mark_of(const Scene<spacedim> &scene, const Session &session)
    {
      const auto mesh =
        scene.geometry.template create<dim>(session.communicator(),
                                            scene.folder);
      std::size_t sum = 0; // of all that a mesh file may have changed
      for (const auto &vertex : mesh->triangulation.get_vertices())
        for (int d = 0; d < spacedim; ++d)
          boost::hash_combine(sum, vertex[d]);
      for (const auto &cell : mesh->triangulation.active_cell_iterators())
        {
          boost::hash_combine(sum, cell->material_id());
          for (const unsigned int v : cell->vertex_indices())
            boost::hash_combine(sum, cell->vertex_index(v));
        }
      return formatted(
        "This run is not finished: started again, it goes on with "
        "the rows of stability.csv.\n%s, %u cells, %zx\n",
        version().c_str(),
        mesh->triangulation.n_active_cells(),
        sum);
    }

    /** What a boundary is one between: verdicts and calibrations. */
    bool
    are_alike(const StabilityRow &a, const StabilityRow &b)
    {
      return a.verdict == b.verdict && a.calibration == b.calibration;
    }

    std::string
    words_of(const StabilityRow &row)
    {
      return row.calibration == "-" ? row.verdict
                                    : row.calibration + ", " + row.verdict;
    }

    /** The middle of two values as an axis is spaced. */
    double
    middle_of(const double a, const double b, const Spacing spacing)
    {
      return spacing == Spacing::logarithmic && a > 0. && b > 0.
               ? std::sqrt(a * b)
               : 0.5 * (a + b);
    }

    using Judgement =
      std::function<StabilityRow(const Variation &, const JudgedModel &)>;

    /** Between two values of an axis with different verdicts. */
    StabilityBoundary
    boundary_between(StabilityRow below,
                     double low,
                     StabilityRow above,
                     double high,
                     const AxisValues &axis,
                     const JudgedModel &model,
                     const double width,
                     const Judgement &judge)
    {
      const auto distance = [&](const double a, const double b) {
        return axis.spacing == Spacing::logarithmic ? std::log(b / a) : b - a;
      };
      const double enough = width * distance(low, high);
      while (distance(low, high) > enough)
        {
          const double middle = middle_of(low, high, axis.spacing);
          if (!(middle > low && middle < high))
            break;
          const auto row = judge({{axis.axis, middle}}, model);
          if (are_alike(row, below))
            {
              low   = middle;
              below = row;
            }
          else
            {
              high  = middle;
              above = row;
            }
        }
      const auto &worse = below.reason.empty() ? above : below;
      return {word_of(stability_axis_words(), axis.axis),
              below.fit,
              below.enrichment,
              below.kinematics,
              below.integrator,
              low,
              high,
              words_of(below),
              words_of(above),
              worse.reason};
    }

    template <int dim, int spacedim>
    std::vector<StabilityBoundary>
    find_boundaries(const StabilityJudge<dim, spacedim> &judge,
                    const StabilitySettings &settings,
                    const std::map<std::string, StabilityRow> &rows,
                    const Judgement &judgement,
                    Progress &progress)
    {
      std::vector<StabilityBoundary> boundaries;
      for (const auto &axis : settings.axes)
        for (const auto &model : judge.models({{axis.axis, 1.}}))
          {
            const auto row_at = [&](const double value) {
              return rows.at(
                key_of(judge.blank_row({{axis.axis, value}}, model)));
            };
            for (std::size_t i = 1; i < axis.values.size(); ++i)
              {
                const auto below = row_at(axis.values[i - 1]);
                const auto above = row_at(axis.values[i]);
                if (!are_alike(below, above))
                  boundaries.push_back(boundary_between(below,
                                                        axis.values[i - 1],
                                                        above,
                                                        axis.values[i],
                                                        axis,
                                                        model,
                                                        settings.width,
                                                        judgement));
              }
            progress.step();
          }
      return boundaries;
    }
  } // namespace

  template <int dim, int spacedim>
  void
  stability(const Scene<spacedim> &scene, Session &session)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(session.communicator()) > 1)
      throw EntryError("Study",
                       "a study of stability runs on one rank.",
                       "Start springfit without mpirun.");
    const auto settings = scene.stability.settings();
    std::vector<std::string> axes;
    for (const auto &axis : settings.axes)
      axes.push_back(word_of(stability_axis_words(), axis.axis));
    const auto mark  = mark_of<dim>(scene, session);
    const auto known = rows_of_stopped_run(session, mark, axes);
    if (!known.empty())
      session.print("Going on where a run of the same scene was stopped: " +
                    std::to_string(known.size()) + " rows are known.");

    StabilityJudge<dim, spacedim> judge(scene, settings, session);
    const auto points  = variations(settings);
    std::size_t n_rows = 0;
    for (const auto &point : points)
      n_rows += judge.models(point).size();
    session.print("Verdicts to be found: " + std::to_string(n_rows) + '.');
    std::ofstream(session.draft() / mark_name) << mark;
    std::ofstream(session.draft() / table_name).close();
    session.publish();

    std::map<std::string, StabilityRow> rows;
    std::vector<StabilityRow> in_order;
    GrowingTable table(session.draft() / table_name, stability_header(axes));
    const auto found = [&](const Variation &variation,
                           const JudgedModel &model) {
      const auto key     = key_of(judge.blank_row(variation, model));
      const auto earlier = known.find(key);
      const auto row = earlier == known.end() ? judge.judge(variation, model)
                                              : earlier->second;
      rows.emplace(key, row);
      return row;
    };
    {
      dealii::TimerOutput::Scope scope(session.timer(), "Verdicts");
      Progress progress("Verdicts", n_rows, session.is_root());
      for (const auto &point : points)
        for (const auto &model : judge.models(point))
          {
            in_order.push_back(found(point, model));
            add_row(in_order.back(), table.row());
            table.append();
            progress.step();
          }
    }
    std::vector<StabilityBoundary> boundaries;
    if (settings.width > 0. && !settings.is_grid)
      {
        dealii::TimerOutput::Scope scope(session.timer(), "Boundaries");
        std::size_t n = 0;
        for (const auto &axis : settings.axes)
          n += judge.models({{axis.axis, 1.}}).size();
        Progress progress("Boundaries", n, session.is_root());
        const auto judgement = [&](const Variation &variation,
                                   const JudgedModel &model) {
          return judge.judge(variation, model);
        };
        boundaries =
          find_boundaries(judge, settings, rows, judgement, progress);
      }
    else
      session.skip("Boundaries",
                   settings.is_grid ? "a grid has no order"
                                    : "'Width = 0' in section Stability");

    dealii::TimerOutput::Scope scope(session.timer(), "Output");
    write_boundaries(session.draft(), boundaries);
    write_stability_page(session.draft(), in_order, boundaries);
    session.print(safe_models(in_order, boundaries));
    if (const auto problem =
          draw(session.draft(), "stability.gp", "stability.md");
        !problem.empty())
      session.warn(problem);
    std::filesystem::remove(session.draft() / mark_name);
    session.say_at_the_end("stability.md shows which model is safe where, "
                           "stability.csv has all verdicts.");
  }

  template void
  stability<2, 2>(const Scene<2> &, Session &);
  template void
  stability<2, 3>(const Scene<3> &, Session &);
  template void
  stability<3, 3>(const Scene<3> &, Session &);
} // namespace springfit
