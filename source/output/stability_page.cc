#include <springfit/core/atomic_file.h>
#include <springfit/core/formatted.h>
#include <springfit/core/words.h>
#include <springfit/output/stability_page.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <map>
#include <ostream>
#include <set>

namespace springfit
{
  namespace
  {
    template <typename Row>
    std::string
    name_of_model(const Row &row)
    {
      std::string name = row.fit;
      if (row.enrichment != "none")
        name += " + " + row.enrichment;
      name += ", " + row.kinematics;
      if (row.integrator != "-")
        name += ", " + row.integrator;
      return name;
    }

    std::string
    number(const double value)
    {
      return formatted("%.4g", value);
    }

    /** "poissons_ratio" as it reads. */
    std::string
    spoken(std::string axis)
    {
      for (const auto &[unit, with] :
           std::vector<std::pair<std::string, std::string>>{{"_Pa", " in Pa"},
                                                            {"_degrees",
                                                             " in degrees"},
                                                            {"_m", " in m"},
                                                            {"_s", " in s"}})
        if (axis.size() > unit.size() &&
            axis.compare(axis.size() - unit.size(), unit.size(), unit) == 0)
          {
            axis.replace(axis.size() - unit.size(), unit.size(), with);
            break;
          }
      std::replace(axis.begin(), axis.end(), '_', ' ');
      for (const std::string name : {"poisson", "young"})
        if (axis.compare(0, name.size() + 1, name + 's') == 0)
          axis = std::string(1, std::toupper(axis[0])) +
                 axis.substr(1, name.size() - 1) + "'s" +
                 axis.substr(name.size() + 1);
      return axis;
    }

    /** Of the words of a boundary: "certified, stable". */
    bool
    is_stable(const std::string &words)
    {
      return words == "stable" ||
             (words.size() > 8 &&
              words.compare(words.size() - 8, 8, ", stable") == 0);
    }

    /** The verdicts along one axis, the others as in the scene. */
    struct Map
    {
      std::vector<double> values;
      std::vector<std::string> models; // in the order of their rows
      std::map<std::pair<std::string, double>, const StabilityRow *> rows;
    };

    std::vector<std::pair<std::string, Map>>
    maps_of(const std::vector<StabilityRow> &rows)
    {
      std::vector<std::pair<std::string, Map>> maps;
      for (const auto &row : rows)
        {
          const auto given = [](const auto &axis) {
            return axis.second.has_value();
          };
          if (std::count_if(row.axes.begin(), row.axes.end(), given) != 1)
            continue;
          const auto axis =
            std::find_if(row.axes.begin(), row.axes.end(), given);
          auto map = std::find_if(maps.begin(), maps.end(), [&](const auto &m) {
            return m.first == axis->first;
          });
          if (map == maps.end())
            {
              maps.emplace_back(axis->first, Map{});
              map = maps.end() - 1;
            }
          auto &found      = map->second;
          const auto model = name_of_model(row);
          if (std::find(found.models.begin(), found.models.end(), model) ==
              found.models.end())
            found.models.push_back(model);
          if (std::find(found.values.begin(),
                        found.values.end(),
                        *axis->second) == found.values.end())
            found.values.push_back(*axis->second);
          found.rows[{model, *axis->second}] = &row;
        }
      return maps;
    }

    std::string
    word_of(const StabilityRow &row)
    {
      return row.verdict == "stable" && row.calibration == "certified"
               ? "certified"
               : row.verdict;
    }

    void
    write_map(const std::string &axis, const Map &map, std::ostream &page)
    {
      page << "## " << spoken(axis) << "\n\n![" << spoken(axis)
           << "](stability_" << axis << ".svg)\n\n| model |";
      for (const double value : map.values)
        page << ' ' << number(value) << " |";
      page << "\n|---|";
      for (std::size_t i = 0; i < map.values.size(); ++i)
        page << "---|";
      page << '\n';
      for (const auto &model : map.models)
        {
          page << "| " << model << " |";
          for (const double value : map.values)
            {
              const auto found = map.rows.find({model, value});
              page << ' '
                   << (found == map.rows.end() ? "" : word_of(*found->second))
                   << " |";
            }
          page << '\n';
        }
      page << '\n';
    }

    void
    write_boundary_table(const std::string &axis,
                         const std::vector<StabilityBoundary> &boundaries,
                         std::ostream &page)
    {
      bool has_head = false;
      for (const auto &boundary : boundaries)
        if (boundary.axis == axis)
          {
            if (!has_head)
              page << "| model | below | up to | from | above | why |\n"
                      "|---|---|---|---|---|---|\n";
            has_head = true;
            page << "| " << name_of_model(boundary) << " | "
                 << boundary.verdict_below << " | " << number(boundary.below)
                 << " | " << number(boundary.above) << " | "
                 << boundary.verdict_above << " | " << boundary.reason
                 << " |\n";
          }
      if (has_head)
        page << '\n';
    }

    unsigned int
    colour_of(const StabilityRow &row)
    {
      if (row.verdict == "stable")
        return 0x2a9d4a;
      return row.verdict == "refused" ? 0x999999 : 0xd62728;
    }

    void
    write_picture(const std::string &axis, const Map &map, std::ostream &plot)
    {
      plot << "$map << END\n";
      for (std::size_t m = 0; m < map.models.size(); ++m)
        for (std::size_t v = 0; v < map.values.size(); ++v)
          if (const auto found = map.rows.find({map.models[m], map.values[v]});
              found != map.rows.end())
            plot << v << ' ' << m << ' ' << colour_of(*found->second) << '\n';
      plot << "END\nset xtics (";
      for (std::size_t v = 0; v < map.values.size(); ++v)
        plot << (v > 0 ? ", " : "") << '"' << number(map.values[v]) << "\" "
             << v;
      plot << ")\nset ytics (";
      for (std::size_t m = 0; m < map.models.size(); ++m)
        plot << (m > 0 ? ", " : "") << '"' << map.models[m] << "\" " << m;
      plot << ") noenhanced\nset xrange [-0.5:" << map.values.size() - 0.5
           << "]\nset yrange [" << map.models.size() - 0.5
           << ":-0.5]\nset xlabel \"" << spoken(axis)
           << "\"\nset title 'green: stable, red: unstable or diverged, grey: "
              "refused'\nunset key\nset terminal svg size 900, "
           << 140 + 28 * map.models.size()
           << " background 'white'\nset output 'stability_" << axis
           << ".svg'\nplot $map using 1:2:3 with points pt 5 ps 2.5 lc rgb "
              "variable\n";
    }

    /** And along which axes it is not stable somewhere. */
    struct ModelVerdicts
    {
      std::string name, integrator;
      std::set<std::string> bad_axes;
    };

    /** In the order of their rows. */
    std::vector<ModelVerdicts>
    verdicts_of_models(const std::vector<StabilityRow> &rows)
    {
      std::vector<ModelVerdicts> models;
      std::map<std::string, std::size_t> numbers;
      for (const auto &row : rows)
        {
          const auto [found, is_new] =
            numbers.emplace(name_of_model(row), models.size());
          if (is_new)
            models.push_back({found->first, row.integrator, {}});
          if (row.verdict == "stable")
            continue;
          auto &axes    = models[found->second].bad_axes;
          bool is_moved = false;
          for (const auto &[axis, value] : row.axes)
            if (value)
              {
                axes.insert(axis);
                is_moved = true;
              }
          if (!is_moved)
            axes.insert("the scene as it is");
        }
      return models;
    }

    /**
     * Those that are stable everywhere; one name where all at rest, or all by
     * an integrator, are.
     */
    std::vector<std::string>
    safe_names(const std::vector<ModelVerdicts> &models)
    {
      std::vector<std::string> names;
      std::set<std::string> integrators;
      for (const auto &model : models)
        {
          if (!integrators.insert(model.integrator).second)
            continue;
          std::vector<std::string> safe;
          std::size_t n = 0;
          for (const auto &other : models)
            if (other.integrator == model.integrator)
              {
                ++n;
                if (other.bad_axes.empty())
                  safe.push_back(other.name);
              }
          if (n > 1 && safe.size() == n)
            safe = {model.integrator == "-"
                      ? "every model at rest"
                      : "every model, " + model.integrator};
          names.insert(names.end(), safe.begin(), safe.end());
        }
      return names;
    }

    /** "stretch below 0.35; time step in s from 0.002" */
    std::string
    ends(const ModelVerdicts &model,
         const std::vector<StabilityBoundary> &boundaries)
    {
      std::vector<std::string> ends;
      for (const auto &axis : model.bad_axes)
        {
          std::string where;
          for (const auto &boundary : boundaries)
            if (boundary.axis == axis && name_of_model(boundary) == model.name)
              {
                const bool is_above = is_stable(boundary.verdict_below);
                if (is_above == is_stable(boundary.verdict_above))
                  continue;
                where += (where.empty() ? "" : " and ") +
                         std::string(is_above ? "from " : "below ") +
                         number(is_above ? boundary.below : boundary.above);
              }
          ends.push_back(spoken(axis) + (where.empty() ? "" : ' ' + where));
        }
      return join(ends, "; ");
    }
  } // namespace

  std::string
  safe_models(const std::vector<StabilityRow> &rows,
              const std::vector<StabilityBoundary> &boundaries)
  {
    const auto models = verdicts_of_models(rows);
    const auto safe   = safe_names(models);
    std::string text =
      safe.empty()
        ? "No model is stable at all points asked for."
        : "Stable at all points asked for: " + join(safe, "; ") + '.';

    // Models that end at the same places share a line.
    std::vector<std::string> lines;
    std::map<std::string, std::vector<std::string>> of_lines;
    for (const auto &model : models)
      if (!model.bad_axes.empty())
        {
          const auto line = ends(model, boundaries);
          if (of_lines.count(line) == 0)
            lines.push_back(line);
          of_lines[line].push_back(model.name);
        }
    std::set<std::string> tried, asked;
    for (const auto &row : rows)
      for (const auto &[axis, value] : row.axes)
        {
          asked.insert(spoken(axis));
          if (value)
            tried.insert(spoken(axis));
        }
    std::vector<std::string> untried;
    std::set_difference(asked.begin(),
                        asked.end(),
                        tried.begin(),
                        tried.end(),
                        std::back_inserter(untried));
    if (!untried.empty())
      text += "\n- Not tried: " + join(untried) +
              ". The scene has no model for it; stretches and inversions take "
              "'Kinematics = nonlinear'.";
    for (const auto &line : lines)
      text += "\n- " + join(of_lines[line], "; ") + ": not with " + line + '.';
    return text;
  }

  void
  write_stability_page(const std::filesystem::path &folder,
                       const std::vector<StabilityRow> &rows,
                       const std::vector<StabilityBoundary> &boundaries)
  {
    const auto maps = maps_of(rows);
    write_file(folder / "stability.gp", [&](std::ostream &plot) {
      plot << "# gnuplot stability.gp makes a picture of each axis.\n";
      for (const auto &[axis, map] : maps)
        write_picture(axis, map, plot);
    });
    write_file(folder / "stability.md", [&](std::ostream &page) {
      page
        << "# What is stable here\n\n"
        << safe_models(rows, boundaries) << "\n\n"
        << (maps.empty() ? "All axes vary together: see stability.csv."
                         : "One thing at a time is not as in the scene.")
        << " Stable: no motion "
           "about rest (about the stretched state, after the push, of all "
           "steps) releases energy or costs none. Certified: so, and the fit "
           "of every cell has a certificate. Refused: there is no model, or "
           "no state, and the table says why.\n\n";
      for (const auto &[axis, map] : maps)
        {
          write_map(axis, map, page);
          write_boundary_table(axis, boundaries, page);
        }
      page << "The numbers are those of stability.csv and "
              "stability_boundaries.csv; used.prm makes them again.\n";
    });
  }
} // namespace springfit
