#ifndef springfit_output_earlier_results_h
#define springfit_output_earlier_results_h

#include <filesystem>

namespace springfit
{
  /**
   * Remove the results of an earlier run from its output folder, so that none
   * is taken for one of the run that begins: comparison.csv, fit.csv,
   * nodes.csv, cells.csv, sweep.csv, springs_*.csv, couplings_*.csv,
   * angles_*.csv, volumes_*.csv, *_fem.csv, and the *.vtu and *.pvd files.
   * Nothing else is touched, and nothing in a folder that has no used.prm.
   *
   * @throws RunError when a file cannot be removed.
   */
  void
  remove_earlier_results(const std::filesystem::path &folder);
} // namespace springfit

#endif
