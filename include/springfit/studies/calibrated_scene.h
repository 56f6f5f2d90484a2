#ifndef springfit_studies_calibrated_scene_h
#define springfit_studies_calibrated_scene_h

#include <springfit/calibration/calibrated_network.h>
#include <springfit/core/session.h>
#include <springfit/output/tables.h>
#include <springfit/studies/scene.h>

#include <memory>
#include <vector>

namespace springfit
{
  /** What every study starts from: a mesh, its materials and its springs. */
  template <int dim, int spacedim = dim>
  struct CalibratedScene
  {
    std::unique_ptr<Mesh<dim, spacedim>> mesh;
    Element<dim, spacedim> element;
    MaterialTable materials;
    double volume; // m^3, of cells of dimension 2 with the thickness
    std::vector<CalibratedNetwork> networks;
  };

  /** As tables take them, for as long as they are there. */
  std::vector<NamedNetwork>
  named(const std::vector<CalibratedNetwork> &networks);

  /**
   * That of a mesh.
   *
   * @throws EntryError when a material does not suit the mesh.
   */
  template <int dim, int spacedim>
  CalibratedScene<dim, spacedim>
  scene_of(std::unique_ptr<Mesh<dim, spacedim>> mesh,
           const Scene<spacedim> &scene);

  /**
   * Make the mesh and say what it is, before anything takes time.
   * The networks are still to come.
   */
  template <int dim, int spacedim>
  CalibratedScene<dim, spacedim>
  make_scene(const Scene<spacedim> &scene, Session &session);

  /**
   * Fit the springs, say what the fits reached and what the springs can and
   * cannot deliver, and write fit.csv, nodes.csv, sets.csv, cells.csv,
   * families.csv, the members of each network, springs_<fit>.csv and so on, and
   * mesh.vtu with the materials and boundaries.vtu.
   *
   * @param held a flag per unknown, see Loading
   * @param responses displacements of the linear finite elements under the
   * scene's loads, one per column, row spacedim * v + d for component d of
   * vertex v; empty where nothing is loaded
   */
  template <int dim, int spacedim>
  void
  calibrate_scene(const Scene<spacedim> &scene,
                  CalibratedScene<dim, spacedim> &calibrated,
                  const std::vector<bool> &held,
                  const Eigen::MatrixXd &responses,
                  Session &session);
} // namespace springfit

#endif
