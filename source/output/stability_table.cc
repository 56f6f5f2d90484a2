#include <springfit/output/stability_table.h>

#include <algorithm>
#include <cstdlib>

namespace springfit
{
  namespace
  {
    std::vector<std::string>
    cells_of(const std::string &line)
    {
      std::vector<std::string> cells(1);
      for (const char c : line)
        if (c == ',')
          cells.emplace_back();
        else
          cells.back() += c;
      return cells;
    }

    /** A sentence as a single cell. */
    std::string
    as_cell(std::string text)
    {
      std::replace(text.begin(), text.end(), ',', ';');
      std::replace(text.begin(), text.end(), '\n', ' ');
      return text;
    }

    /** The numbers behind the words, in the order of the columns. */
    template <typename Row, typename Function>
    void
    for_each_number(Row &row, const Function &f)
    {
      for (auto *number : {&row.cell_eigenvalue,
                           &row.network_eigenvalue,
                           &row.condition,
                           &row.gap})
        f(*number);
      for (auto *number : {&row.n_negative, &row.n_unstable, &row.n_mechanisms})
        f(*number);
      for (auto *number : {&row.predicted_step,
                           &row.observed_step,
                           &row.energy_drift,
                           &row.e_rms,
                           &row.youngs_modulus,
                           &row.poissons_ratio,
                           &row.iterations})
        f(*number);
    }

    template <typename Row>
    auto
    words_in(Row &row)
    {
      return std::vector{&row.fit,
                         &row.enrichment,
                         &row.kinematics,
                         &row.integrator,
                         &row.calibration,
                         &row.verdict,
                         &row.reason};
    }
  } // namespace

  std::string
  stability_header(const std::vector<std::string> &axes)
  {
    std::string header;
    for (const auto &axis : axes)
      header += axis + ',';
    return header +
           "fit,enrichment,kinematics,integrator,calibration,verdict,reason,"
           "cell_eigenvalue,network_eigenvalue,condition,duality_gap,n_negative,"
           "n_unstable,n_mechanisms,predicted_step_s,observed_step_s,"
           "energy_drift,e_rms_percent,E_out,nu_out,iterations";
  }

  void
  add_row(const StabilityRow &row, CsvTable &table)
  {
    for (const auto &axis : row.axes)
      table << axis.second;
    for (const auto *word : words_in(row))
      table << as_cell(*word);
    for_each_number(row, [&](const auto &number) {
      table << (number ? std::optional<double>(*number) : std::nullopt);
    });
  }

  std::string
  key_of(const StabilityRow &row)
  {
    CsvTable table("");
    table.new_row();
    for (const auto &axis : row.axes)
      table << axis.second;
    table << row.fit << row.enrichment << row.kinematics << row.integrator;
    return table.take_rows();
  }

  std::optional<StabilityRow>
  parse_row(const std::string &line, const std::vector<std::string> &axes)
  {
    const auto cells = cells_of(line);
    StabilityRow row;
    std::size_t next     = 0;
    const auto number_of = [&](const std::string &text) {
      return text.empty() ? std::optional<double>()
                          : std::strtod(text.c_str(), nullptr);
    };
    constexpr std::size_t n_others = 21;
    if (cells.size() != axes.size() + n_others)
      return {};
    for (const auto &axis : axes)
      row.axes.emplace_back(axis, number_of(cells[next++]));
    for (auto *word : words_in(row))
      *word = cells[next++];
    for_each_number(row, [&](auto &number) {
      if (const auto value = number_of(cells[next++]))
        number = *value;
    });
    return row;
  }

  void
  write_boundaries(const std::filesystem::path &folder,
                   const std::vector<StabilityBoundary> &boundaries)
  {
    CsvTable table("axis,fit,enrichment,kinematics,integrator,below,above,"
                   "verdict_below,verdict_above,reason");
    for (const auto &boundary : boundaries)
      {
        table.new_row();
        table << boundary.axis << boundary.fit << boundary.enrichment
              << boundary.kinematics << boundary.integrator << boundary.below
              << boundary.above << boundary.verdict_below
              << boundary.verdict_above << as_cell(boundary.reason);
      }
    table.write(folder / "stability_boundaries.csv");
  }


} // namespace springfit
