#ifndef springfit_output_adapt_table_h
#define springfit_output_adapt_table_h

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** How long a step of motion takes, s, where it can be done. */
  struct StepTimes
  {
    std::optional<double> explicit_step, implicit_step;
  };

  /** A cycle of an adaptation, the worst of all load cases. */
  struct AdaptRow
  {
    std::vector<unsigned int> n_cells; // of each model
    double estimate;                   // per cent
    std::optional<double> error;       // the true one, per cent
    StepTimes steps;
  };

  /**
   * adapt.csv; @p names are those of the models, @p of_richest the times of the
   * last of them in all cells.
   */
  void
  write_adaptation(const std::filesystem::path &folder,
                   const std::vector<AdaptRow> &rows,
                   const StepTimes &of_richest,
                   const std::vector<std::string> &names);

  /** models_of_cells.csv: a row per cell, with the name of its model. */
  void
  write_models_of_cells(const std::filesystem::path &folder,
                        const std::vector<unsigned int> &models,
                        const std::vector<std::string> &names);

  /** For the screen. */
  std::string
  adapt_lines(const std::vector<AdaptRow> &rows,
              const StepTimes &of_richest,
              const std::vector<std::string> &names);
} // namespace springfit

#endif
