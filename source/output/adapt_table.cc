#include <springfit/output/adapt_table.h>
#include <springfit/output/csv.h>

#include <cstdio>

namespace springfit
{
  namespace
  {
    std::optional<double>
    ratio(const std::optional<double> &a, const std::optional<double> &b)
    {
      if (a && b && *b > 0.)
        return *a / *b;
      return {};
    }

    std::string
    text_of(const std::optional<double> &value, const char *format)
    {
      char text[32];
      if (!value)
        return "-";
      std::snprintf(text, sizeof(text), format, *value);
      return text;
    }
  } // namespace

  void
  write_adaptation(const std::filesystem::path &folder,
                   const std::vector<AdaptRow> &rows,
                   const StepTimes &of_richest,
                   const std::vector<std::string> &names)
  {
    std::string header = "cycle";
    for (const auto &name : names)
      header += ",cells_" + name;
    CsvTable table(
      header + ",estimated_percent,true_percent,effectivity,explicit_step_s,"
               "implicit_step_s,explicit_step_of_richest_s,"
               "implicit_step_of_richest_s");
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const auto &row = rows[i];
        table.new_row();
        table << static_cast<unsigned int>(i);
        for (const unsigned int n : row.n_cells)
          table << n;
        table << row.estimate << row.error << ratio(row.estimate, row.error)
              << row.steps.explicit_step << row.steps.implicit_step
              << of_richest.explicit_step << of_richest.implicit_step;
      }
    table.write(folder / "adapt.csv");
  }

  void
  write_models_of_cells(const std::filesystem::path &folder,
                        const std::vector<unsigned int> &models,
                        const std::vector<std::string> &names)
  {
    CsvTable table("model");
    for (const unsigned int model : models)
      {
        table.new_row();
        table << names[model];
      }
    table.write(folder / "models_of_cells.csv");
  }

  std::string
  adapt_lines(const std::vector<AdaptRow> &rows,
              const StepTimes &of_richest,
              const std::vector<std::string> &names)
  {
    std::string lines = "\nModels of cells, from cheap to exact:";
    for (std::size_t k = 0; k < names.size(); ++k)
      lines += (k > 0 ? ", " : " ") + std::to_string(k) + " " + names[k];
    lines += "\nErrors in % of what the exact model has; times relative to "
             "the last model in all cells.\n"
             "cycle  estimate      true  explicit  implicit  cells of each "
             "model\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const auto &row = rows[i];
        char text[128];
        std::snprintf(
          text,
          sizeof(text),
          "%5zu %9s %9s %9s %9s ",
          i,
          text_of(row.estimate, "%.3g").c_str(),
          text_of(row.error, "%.3g").c_str(),
          text_of(ratio(row.steps.explicit_step, of_richest.explicit_step),
                  "%.2f")
            .c_str(),
          text_of(ratio(row.steps.implicit_step, of_richest.implicit_step),
                  "%.2f")
            .c_str());
        lines += text;
        for (const unsigned int n : row.n_cells)
          lines += ' ' + std::to_string(n);
        lines += '\n';
      }
    return lines;
  }
} // namespace springfit
