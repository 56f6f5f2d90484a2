#ifndef springfit_output_motion_table_h
#define springfit_output_motion_table_h

#include <springfit/comparison/errors.h>
#include <springfit/motion/energy_account.h>
#include <springfit/output/csv.h>

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What a table says of a moment of a motion; vectors of dim components. */
  struct MotionRow
  {
    double time;                      // s
    double kinetic, elastic, contact; // energies, J
    EnergyAccount account;
    Eigen::VectorXd momentum;         // kg m/s
    Eigen::VectorXd angular_momentum; // about the origin, kg m^2/s; (z) in 2-d

    /** As many as there are names in the header. */
    std::vector<Eigen::VectorXd> vectors;
  };

  /** The header for rows whose vectors have these names. */
  std::string
  motion_header(const std::vector<std::string> &names);

  /** A row of it; what a plane motion lacks is 0. */
  void
  write_motion_row(const MotionRow &row, CsvTable &table);

  /** A row of dynamics.csv: how a model moved under a load case. */
  struct MotionSummary
  {
    std::string load_case, fit, enrichment, kinematics;
    std::uint64_t n_steps;
    double step;                         // s
    std::optional<double> critical_step; // s, of symplectic Euler's method
    double seconds_of_step;              // wall time, the mean of all
    std::optional<double> iterations;    // mean of a solution of equations
    double peak;                         // largest displacement, m

    /** From the finite elements, over all rows of the tables. */
    std::optional<ErrorNorms> errors;
  };

  /** dynamics.csv */
  void
  write_motion_summaries(const std::filesystem::path &folder,
                         const std::vector<MotionSummary> &rows);

  /**
   * A name in a column: its letters and digits, all else an underscore; with a
   * number behind if it is among @p others.
   */
  std::string
  column_name(const std::string &name, const std::vector<std::string> &others);
} // namespace springfit

#endif
