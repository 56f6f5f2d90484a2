#include <springfit/core/atomic_file.h>
#include <springfit/core/words.h>
#include <springfit/output/tradeoff_page.h>
#include <springfit/output/tradeoff_table.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <ostream>

namespace springfit
{
  namespace
  {
    std::string
    text_of(const char *format, const double value)
    {
      char text[64];
      std::snprintf(text, sizeof(text), format, value);
      return text;
    }

    std::string
    cell_of(const std::optional<double> &value, const double unit = 1.)
    {
      return value ? text_of("%.3g", *value / unit) : "";
    }

    std::string
    axis_of(const Demand &demand)
    {
      switch (demand.purpose)
        {
          case Purpose::statics:
            return "time of a solution, ms";
          case Purpose::implicit_motion:
            return "time of an implicit step of " +
                   text_of("%.3g", demand.time_step) + " s, ms";
          default:
            return "time of the explicit steps of " +
                   text_of("%.3g", demand.time_step) + " s, ms";
        }
    }

    std::optional<double>
    cost(const TradeoffRow &row, const Demand &demand)
    {
      return springfit::cost(row, demand.purpose, demand.time_step);
    }

    /** Rows with an error, from cheap to expensive; those without a cost last.
     */
    std::vector<std::size_t>
    by_cost(const std::vector<TradeoffRow> &rows, const Demand &demand)
    {
      std::vector<std::size_t> order(rows.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const std::size_t a, const std::size_t b) {
                         return cost(rows[a], demand).value_or(1e300) <
                                cost(rows[b], demand).value_or(1e300);
                       });
      return order;
    }

    void
    write_table(const std::vector<TradeoffRow> &rows,
                const Demand &demand,
                const Advice &advice,
                std::ostream &page)
    {
      page << "| model | cells | size, mm | unknowns | e_rms, % | e_max, % | "
              "force, % | energy, % | quantity, % | calibrate, s | solve, ms | "
              "implicit step, ms | explicit step, ms | its limit, ms | MiB |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
      for (const std::size_t i : by_cost(rows, demand))
        {
          const auto &row        = rows[i];
          const std::string mark = advice.chosen == i ? "**"
                                   : row.is_on_front  ? "*"
                                                      : "";
          page << "| " << mark << name_of_model(row) << mark << " | "
               << row.cells << " | " << text_of("%.4g", 1e3 * row.cell_size)
               << " | " << row.n_dofs << " | " << cell_of(row.e_rms) << " | "
               << cell_of(row.e_max) << " | " << cell_of(row.force_error)
               << " | " << cell_of(row.energy_error) << " | "
               << cell_of(row.quantity_error) << " | " << cell_of(row.calibrate)
               << " | " << cell_of(row.solve, 1e-3) << " | "
               << cell_of(row.implicit_step, 1e-3) << " | "
               << cell_of(row.explicit_step, 1e-3) << " | "
               << cell_of(row.stable_step, 1e-3) << " | " << cell_of(row.memory)
               << " |\n";
        }
    }

    /** A dashed line across the picture at an error in per cent. */
    std::string
    level(const double error, const std::string &label)
    {
      const std::string place = text_of("%.6g", error);
      return "set arrow from graph 0, first " + place + " to graph 1, first " +
             place + " nohead ls 99\nset label '" + label +
             "' at graph 0.01, first " + place +
             " offset 0, 0.5 textcolor '#666666'\n";
    }

    /** A curve for each model over its cell sizes, and the front. */
    void
    write_plot(const std::vector<TradeoffRow> &rows,
               const Demand &demand,
               const Advice &advice,
               const ReferenceFacts &facts,
               std::ostream &plot)
    {
      std::map<std::string, std::vector<std::size_t>> curves;
      std::vector<std::string> order;
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].e_rms && cost(rows[i], demand))
          {
            const std::string name =
              name_of_model(rows[i]) + ", " + rows[i].cells;
            if (curves.count(name) == 0)
              order.push_back(name);
            curves[name].push_back(i);
          }
      plot << "# gnuplot tradeoff.gp makes tradeoff.svg and tradeoff.png.\n";
      const auto block = [&](const std::string &name,
                             const std::vector<std::size_t> &points) {
        plot << '$' << name << " << END\n";
        for (const std::size_t i : points)
          plot << text_of("%.6g", 1e3 * *cost(rows[i], demand)) << ' '
               << text_of("%.6g", *rows[i].e_rms) << '\n';
        plot << "END\n";
      };
      for (std::size_t c = 0; c < order.size(); ++c)
        block("curve" + std::to_string(c), curves[order[c]]);
      std::vector<std::size_t> front;
      for (const std::size_t i : by_cost(rows, demand))
        if (rows[i].is_on_front)
          front.push_back(i);
      block("front", front);
      if (advice.chosen)
        block("chosen", {*advice.chosen});

      double lowest = demand.accuracy, highest = demand.accuracy;
      for (const auto &[name, points] : curves)
        for (const std::size_t i : points)
          {
            lowest  = std::min(lowest, *rows[i].e_rms);
            highest = std::max(highest, *rows[i].e_rms);
          }
      if (facts.own_error && *facts.own_error > 0.)
        lowest = std::min(lowest, *facts.own_error);
      // Exact models are as good as rounding errors.
      lowest = std::max(lowest, 1e-6);
      plot << "set yrange [" << text_of("%.3g", 0.5 * lowest) << ':'
           << text_of("%.3g", 2. * highest) << "]\n";
      plot
        << "set logscale xy\nset grid\nset rmargin at screen 0.58\n"
           "set key at screen 0.59, screen 0.98 left top Left reverse samplen 2 "
           "spacing 1.2 font ',9' noenhanced\nset xlabel '"
        << axis_of(demand)
        << "'\nset ylabel 'rms distance from the reference, %'\n"
           "set style line 99 lc rgb '#888888' lw 2 dt 2\n"
        << level(demand.accuracy, "accuracy");
      if (facts.own_error && *facts.own_error > 0.)
        plot << level(*facts.own_error, "the reference itself");
      if (demand.budget > 0.)
        plot << "set arrow from " << text_of("%.6g", 1e3 * demand.budget)
             << ", graph 0 to " << text_of("%.6g", 1e3 * demand.budget)
             << ", graph 1 nohead ls 99\n";
      std::string curves_text;
      for (std::size_t c = 0; c < order.size(); ++c)
        curves_text += (c > 0 ? ", \\\n     " : "") + std::string("$curve") +
                       std::to_string(c) + " with linespoints lw 1.5 pt " +
                       std::to_string(4 + c % 10) + " title \"" + order[c] +
                       '"';
      if (!front.empty())
        curves_text += ", \\\n     $front with steps lw 3 lc rgb 'black' title "
                       "'front'";
      if (advice.chosen)
        curves_text += ", \\\n     $chosen with points pt 6 ps 3 lw 2 lc rgb "
                       "'red' title 'recommended'";
      const std::string size =
        "1100, " + std::to_string(
                     std::max<std::size_t>(560, 60 + 16 * (order.size() + 2)));
      plot << "set terminal svg size " << size
           << " background 'white'\n"
              "set output 'tradeoff.svg'\n"
              "plot "
           << curves_text << "\nset terminal png size " << size
           << "\n"
              "set output 'tradeoff.png'\n"
              "replot\n";
    }
  } // namespace

  std::string
  describe(const ReferenceFacts &facts)
  {
    std::string text = "Reference: finite elements of degree " +
                       std::to_string(facts.degree) + " (" +
                       facts.material_law + "), " + facts.cells + " of " +
                       text_of("%.4g", 1e3 * facts.cell_size) + " mm, " +
                       std::to_string(facts.n_nodes) + " nodes. ";
    if (facts.own_error)
      text += "Elements of twice that size are " +
              text_of("%.2g", *facts.own_error) +
              " % of the largest displacement away: its own error is less.";
    else
      text += "Its own error is not known.";
    return text;
  }

  void
  write_page(const std::filesystem::path &folder,
             const std::vector<TradeoffRow> &rows,
             const Demand &demand,
             const Advice &advice,
             const ReferenceFacts &facts)
  {
    write_file(folder / "tradeoff.gp", [&](std::ostream &plot) {
      write_plot(rows, demand, advice, facts, plot);
    });
    write_file(folder / "tradeoff.md", [&](std::ostream &page) {
      page << "# What accuracy costs here\n\n"
           << sentence(rows, demand, advice, facts.own_error)
           << "\n\n![Error over time](tradeoff.svg)\n\n"
           << describe(facts) << " Load cases: " << join(facts.load_cases)
           << (facts.quantity.empty() ? "" : "; quantity: " + facts.quantity)
           << ".\n\n";
      write_table(rows, demand, advice, page);
      page << "\nErrors are distances from the reference at its vertices, the "
              "worst of all load cases, in % of its largest displacement, of "
              "the largest force of a support, of the energy and of the "
              "quantity. Bold: recommended. Italic: on the front, where no "
              "model is both cheaper and more accurate. Times are medians of "
              "measurements in which the models take turns, of one load case "
              "and of one step. An explicit step has a limit, beyond which it "
              "is unstable.\n\nThe numbers are those of tradeoff.csv; "
              "used.prm makes them again.\n";
    });
  }
} // namespace springfit
