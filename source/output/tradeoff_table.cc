#include <springfit/core/formatted.h>
#include <springfit/output/csv.h>
#include <springfit/output/tradeoff_table.h>


namespace springfit
{
  namespace
  {
    /** A percentage, or a dash. */
    std::string
    percent(const std::optional<double> &value)
    {
      return value ? formatted("%.3g", *value) : "-";
    }

    std::string
    milliseconds(const std::optional<double> &seconds)
    {
      return seconds ? formatted("%.3g", 1e3 * *seconds) : "-";
    }

    std::string
    what_costs(const Demand &demand)
    {
      switch (demand.purpose)
        {
          case Purpose::statics:
            return "a solution";
          case Purpose::implicit_motion:
            return formatted("a step of %.3g s", demand.time_step);
          default:
            return formatted("the explicit steps of %.3g s", demand.time_step);
        }
    }

    std::string
    accuracy_and_cost(const TradeoffRow &row, const Demand &demand)
    {
      return percent(row.e_rms) + " % from the reference, " +
             milliseconds(cost(row, demand.purpose, demand.time_step)) +
             " ms for " + what_costs(demand);
    }
  } // namespace

  std::string
  name_of_model(const TradeoffRow &row)
  {
    if (row.model == "fem")
      return "finite elements, " + row.fit;
    return row.fit + (row.enrichment == "none" ? "" : " + " + row.enrichment) +
           ", " + row.kinematics;
  }

  std::string
  name_of(const TradeoffRow &row)
  {
    return name_of_model(row) + ", " + row.cells +
           formatted(" of %.4g mm", 1e3 * row.cell_size);
  }

  void
  write_tradeoff(const std::filesystem::path &folder,
                 const std::vector<TradeoffRow> &rows)
  {
    CsvTable table(
      "model,fit,enrichment,kinematics,cells,cell_size_m,n_dofs,n_springs,"
      "e_rms_percent,e_max_percent,force_error_percent,calibrate_s,setup_s,"
      "solve_s,implicit_step_s,explicit_step_s,memory_MiB,pareto,"
      "energy_error_percent,quantity_error_percent,stable_step_s,"
      "spread_percent");
    for (const auto &row : rows)
      {
        table.new_row();
        table << row.model << row.fit << row.enrichment << row.kinematics
              << row.cells << row.cell_size << row.n_dofs;
        if (row.n_springs)
          table << *row.n_springs;
        else
          table << std::string();
        table << row.e_rms << row.e_max << row.force_error << row.calibrate
              << row.setup << row.solve << row.implicit_step
              << row.explicit_step << row.memory
              << std::string(row.is_on_front ? "yes" : "no") << row.energy_error
              << row.quantity_error << row.stable_step << row.spread;
      }
    table.write(folder / "tradeoff.csv");
  }

  std::string
  tradeoff_lines(const std::vector<TradeoffRow> &rows, const Demand &demand)
  {
    std::string lines =
      "\nModels (* on the front: none is both cheaper and more accurate; "
      "errors in % from the reference, times in ms):\n"
      "  model                                        cells          size mm  "
      "unknowns    e_rms    e_max    solve   implicit  explicit   cost\n";
    for (const auto &row : rows)
      lines += formatted(
        "%c %-44s %-14s %7.4g %9u %8s %8s %8s %10s %9s %6s\n",
        row.is_on_front ? '*' : ' ',
        name_of_model(row).c_str(),
        row.cells.c_str(),
        1e3 * row.cell_size,
        row.n_dofs,
        percent(row.e_rms).c_str(),
        percent(row.e_max).c_str(),
        milliseconds(row.solve).c_str(),
        milliseconds(row.implicit_step).c_str(),
        milliseconds(row.explicit_step).c_str(),
        milliseconds(cost(row, demand.purpose, demand.time_step)).c_str());
    return lines;
  }

  std::string
  sentence(const std::vector<TradeoffRow> &rows,
           const Demand &demand,
           const Advice &advice,
           const std::optional<double> &error_of_reference)
  {
    const auto tell = [&](const std::size_t i) {
      return name_of(rows[i]) + " (" + accuracy_and_cost(rows[i], demand) + ")";
    };
    std::string text;
    if (advice.chosen)
      {
        text =
          "Take " + tell(*advice.chosen) +
          formatted(": the cheapest model within %.3g %%", demand.accuracy) +
          (demand.budget > 0. ? formatted(" and %.3g ms.", 1e3 * demand.budget)
                              : ".");
        if (const auto finer = finer_and_worse(rows, *advice.chosen))
          text +=
            formatted(" On cells of %.4g mm its error is %.3g %%: on these "
                      "softness and locking cancel in part, which other "
                      "meshes and loads may not repeat.",
                      1e3 * rows[*finer].cell_size,
                      *rows[*finer].e_rms);
      }
    else if (!advice.most_accurate)
      text = "No model could be measured; the warnings say why.";
    else if (!advice.cheapest_accurate)
      {
        text = formatted("No model is within %.3g %%: the most accurate is ",
                         demand.accuracy) +
               tell(*advice.most_accurate) +
               ". Ask for finer cells ('Halvings'), other fits or enrichments, "
               "or less accuracy.";
        if (demand.budget > 0. && advice.most_accurate_affordable &&
            advice.most_accurate_affordable != advice.most_accurate)
          text += formatted(" Within %.3g ms it is ", 1e3 * demand.budget) +
                  tell(*advice.most_accurate_affordable) + '.';
      }
    else
      {
        const auto &row = rows[*advice.cheapest_accurate];
        text = formatted("No model within %.3g %% takes only %.3g ms: the "
                         "cheapest takes %.3g times that, ",
                         demand.accuracy,
                         1e3 * demand.budget,
                         *cost(row, demand.purpose, demand.time_step) /
                           demand.budget) +
               tell(*advice.cheapest_accurate) + '.';
        if (advice.most_accurate_affordable)
          text += formatted(" The most accurate within %.3g ms is ",
                            1e3 * demand.budget) +
                  tell(*advice.most_accurate_affordable) + '.';
      }
    if (error_of_reference && *error_of_reference > demand.accuracy / 3.)
      text += formatted(" The reference itself changes by %.2g %% when its "
                        "cells are twice as large: give it smaller ones to be "
                        "sure ('Reference cell size', of a mesh file "
                        "'Halvings').",
                        *error_of_reference);
    return text;
  }
} // namespace springfit
