#ifndef springfit_studies_network_exports_h
#define springfit_studies_network_exports_h

#include <springfit/core/session.h>
#include <springfit/exports/exporters.h>
#include <springfit/response/load_case.h>
#include <springfit/response/statics.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/scene.h>

#include <string>
#include <vector>

namespace springfit
{
  // The networks of a study for other programs, as section Output asks.

  template <int dim>
  std::vector<Exporter>
  exporters(const OutputSection<dim> &output);

  /** A network under a load, called export_<case>_<name>. */
  ExportedScene
  scene_of_network(const SpringNetwork &network,
                   const std::string &name,
                   const std::vector<bool> &held,
                   const LoadCase &load_case);

  // Checks before the networks are put to use: free ones, under loads, and
  // those that will move. @p held is a flag per unknown, see Loading. @throws
  // EntryError when a format can hold none of them.

  template <int dim, int spacedim>
  void
  check_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated);

  template <int dim, int spacedim>
  void
  check_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                const std::vector<bool> &held,
                const std::vector<LoadCase> &cases);

  template <int dim, int spacedim>
  void
  check_moving_exports(const Scene<spacedim> &scene,
                       const CalibratedScene<dim, spacedim> &calibrated,
                       const std::vector<bool> &held);

  // Writing, by the first rank; all must call it. Warnings say what a program
  // cannot hold, and what it leaves out of what it can. @throws RunError when
  // a file cannot be written.

  /**
   * For every program that can hold them, in the kinematics of the comparison
   * where the program knows both.
   */
  void
  write_exports(const std::vector<Exporter> &exporters,
                const std::vector<Kinematics> &kinematics,
                const std::vector<ExportedScene> &scenes,
                Session &session);

  /** All networks at rest. */
  template <int dim, int spacedim>
  void
  write_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                Session &session);

  /** All networks under all loads. */
  template <int dim, int spacedim>
  void
  write_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                const std::vector<bool> &held,
                const std::vector<LoadCase> &cases,
                Session &session);

  /** As they move, under the loads at the beginning. */
  template <int dim, int spacedim>
  void
  write_moving_exports(const Scene<spacedim> &scene,
                       const CalibratedScene<dim, spacedim> &calibrated,
                       const Loading &loading,
                       Session &session);
} // namespace springfit

#endif
