#ifndef springfit_output_stability_table_h
#define springfit_output_stability_table_h

#include <springfit/output/csv.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /** What a study of stability found of a model at one point of its axes. */
  struct StabilityRow
  {
    /** By column: "poissons_ratio", ...; empty where the scene's own holds. */
    std::vector<std::pair<std::string, std::optional<double>>> axes;

    std::string fit, enrichment, kinematics, integrator; // "-" where none

    std::string calibration; // certified, accepted, refused
    std::string verdict;     // stable, unstable, diverged, refused
    std::string reason;      // why it is not stable

    std::optional<double> cell_eigenvalue;    // smallest of a cell, to ||R||_2
    std::optional<double> network_eigenvalue; // smallest, held, to the largest
    std::optional<double> condition;
    std::optional<double> gap;
    std::optional<unsigned int> n_negative, n_unstable, n_mechanisms;
    std::optional<double> predicted_step, observed_step; // s
    std::optional<double> energy_drift; // relative, of all steps
    std::optional<double> e_rms;        // per cent
    std::optional<double> youngs_modulus, poissons_ratio; // delivered
    std::optional<double> iterations;
  };

  /** Where a verdict changes between two values of an axis. */
  struct StabilityBoundary
  {
    std::string axis;
    std::string fit, enrichment, kinematics, integrator;
    double below, above; // values
    std::string verdict_below, verdict_above;
    std::string reason; // of the worse of the two
  };

  /** The columns of stability.csv. */
  std::string
  stability_header(const std::vector<std::string> &axes);

  /** Into a row that has begun. */
  void
  add_row(const StabilityRow &row, CsvTable &table);

  /** What tells a row from the others: the first columns, "0.45,,,consistent".
   */
  std::string
  key_of(const StabilityRow &row);

  /**
   * The row of a line of stability.csv.
   *
   * @return nothing when it is not whole
   */
  std::optional<StabilityRow>
  parse_row(const std::string &line, const std::vector<std::string> &axes);

  void
  write_boundaries(const std::filesystem::path &folder,
                   const std::vector<StabilityBoundary> &boundaries);

} // namespace springfit

#endif
