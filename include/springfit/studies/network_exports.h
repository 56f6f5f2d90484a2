#ifndef springfit_studies_network_exports_h
#define springfit_studies_network_exports_h

#include <springfit/core/session.h>
#include <springfit/exports/exporters.h>
#include <springfit/response/load_case.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/scene.h>

#include <vector>

namespace springfit
{
  // The networks of a study for other programs, as section Output asks.

  template <int dim>
  std::vector<Exporter>
  exporters(const OutputSection<dim> &output);

  /**
   * Warn of each of the scenes, one for each network, that a format cannot
   * hold.
   *
   * @throws EntryError when a format can hold none of them.
   */
  void
  check_exports(const std::vector<Exporter> &exporters,
                const std::vector<ExportedScene> &scenes,
                Session &session);

  /**
   * The same of the networks of a scene.
   *
   * @param held a flag per unknown, see Loading
   */
  template <int dim, int spacedim>
  void
  check_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                const std::vector<bool> &held,
                Session &session);

  // Writing, by the first rank; all must call it. @throws RunError when a file
  // cannot be written.

  /**
   * A scene for every program that can hold it, in the kinematics of the
   * comparison where the program knows both.
   */
  void
  write_exports(const std::vector<Exporter> &exporters,
                const std::vector<Kinematics> &kinematics,
                const std::vector<ExportedScene> &scenes,
                Session &session);

  /** All networks at rest, called <fit>. */
  template <int dim, int spacedim>
  void
  write_exports(const Scene<spacedim> &scene,
                const CalibratedScene<dim, spacedim> &calibrated,
                Session &session);

  /** All networks under all loads, called <case>_<fit>. */
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
