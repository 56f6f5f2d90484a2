#ifndef springfit_studies_openings_h
#define springfit_studies_openings_h

#include <springfit/calibration/calibrated_network.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/mesh/mesh.h>
#include <springfit/motion/dynamics.h>
#include <springfit/springs/network.h>
#include <springfit/studies/calibrated_scene.h>

#include <vector>

namespace springfit
{
  /** What is left of a mesh. */
  struct Remains
  {
    /** By active cell index: whether it is still there. */
    std::vector<bool> cells;

    /** A flag per node: it has no cell any more. */
    std::vector<bool> lost_nodes;
  };

  /** All of a mesh. */
  template <int dim, int spacedim>
  Remains
  everything(const Mesh<dim, spacedim> &mesh);

  /**
   * What an opening leaves of what was left before.
   *
   * @throws EntryError when it takes out no cell or all that are left.
   */
  template <int dim, int spacedim>
  Remains
  opened(const Opening &opening,
         const Mesh<dim, spacedim> &mesh,
         const Remains &before);

  /**
   * The springs of the cells that are left. What a cell adds to springs on the
   * rim goes with it, so that a body at rest stays there; constants of whole
   * objects know no cells, and keep it: see within().
   *
   * @param cells see cells_of_fits()
   */
  template <int dim, int spacedim>
  SpringNetwork
  opened(const CalibratedNetwork &network,
         const CalibratedScene<dim, spacedim> &calibrated,
         const DistinctCells &cells,
         const Remains &remains);
} // namespace springfit

#endif
