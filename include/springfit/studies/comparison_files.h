#ifndef springfit_studies_comparison_files_h
#define springfit_studies_comparison_files_h

#include <springfit/response/load_case.h>
#include <springfit/response/statics.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/responses.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** What the names of files say of the springs' kinematics. */
  std::string
  suffix_of(Kinematics kinematics);

  // On one rank. @throws RunError when a file cannot be written.

  /**
   * The displacements of all cases and models, and the networks:
   * <case>_fem.vtu, <case>_<fit>.vtu, springs_<fit>.vtu (see
   * write_network_vtu()) and a series of the cases for each model. What did not
   * reach the whole load is called *_incomplete.vtu.
   */
  template <int dim, int spacedim>
  void
  write_pictures(const std::filesystem::path &folder,
                 const CalibratedScene<dim, spacedim> &calibrated,
                 const std::vector<CaseResult> &results);

  /** <case>_fem.csv and <case>_<fit>.csv, where the whole load is borne. */
  template <int dim, int spacedim>
  void
  write_responses(const std::filesystem::path &folder,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  const Loading &loading,
                  const std::vector<CaseResult> &results);
} // namespace springfit

#endif
