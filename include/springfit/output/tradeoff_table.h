#ifndef springfit_output_tradeoff_table_h
#define springfit_output_tradeoff_table_h

#include <springfit/comparison/tradeoff.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** "consistent + volume, nonlinear": a model on any mesh. */
  std::string
  name_of_model(const TradeoffRow &row);

  /** "..., hexahedra of 2.5 mm" */
  std::string
  name_of(const TradeoffRow &row);

  /** tradeoff.csv */
  void
  write_tradeoff(const std::filesystem::path &folder,
                 const std::vector<TradeoffRow> &rows);

  /** The most telling columns for the screen, a line for each row. */
  std::string
  tradeoff_lines(const std::vector<TradeoffRow> &rows, const Demand &demand);

  /** What to take, or what cannot be had and by how much. */
  std::string
  sentence(const std::vector<TradeoffRow> &rows,
           const Demand &demand,
           const Advice &advice,
           const std::optional<double> &error_of_reference);
} // namespace springfit

#endif
