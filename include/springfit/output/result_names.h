#ifndef springfit_output_result_names_h
#define springfit_output_result_names_h

#include <string>

namespace springfit
{
  /**
   * Whether a study writes results of this name, without a folder:
   * comparison.csv, fit.csv, nodes.csv, cells.csv, sweep.csv, springs_*.csv,
   * couplings_*.csv, angles_*.csv, volumes_*.csv, *_fem.csv, and the *.vtu and
   * *.pvd files. They are what a run takes the place of.
   */
  bool
  is_result(const std::string &name);
} // namespace springfit

#endif
