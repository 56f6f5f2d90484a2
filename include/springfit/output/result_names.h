#ifndef springfit_output_result_names_h
#define springfit_output_result_names_h

#include <string>
#include <vector>

namespace springfit
{
  /**
   * Whether a study writes results of this name, without a folder:
   * comparison.csv, reactions.csv, dynamics.csv, checkpoint.bin, fit.csv,
   * nodes.csv, cells.csv, sweep.csv, springs_*.csv, couplings_*.csv,
   * angles_*.csv, volumes_*.csv, <case>_<model>.csv of one of the @p models,
   * which may go on after an underscore, families.csv, sets.csv, scenes for
   * other programs (export_*), and the *.vtu and *.pvd files. They are what a
   * run takes the place of.
   */
  bool
  is_result(const std::string &name, const std::vector<std::string> &models);
} // namespace springfit

#endif
