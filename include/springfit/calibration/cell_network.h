#ifndef springfit_calibration_cell_network_h
#define springfit_calibration_cell_network_h

#include <springfit/calibration/cell_fits.h>
#include <springfit/springs/network.h>

namespace springfit
{
  /**
   * The network of all cells: each a copy of a distinct cell, whose constants
   * are scaled to its size.
   *
   * @param models by position in cells.distinct
   */
  template <int dim, int spacedim>
  SpringNetwork
  assemble_network(const Mesh<dim, spacedim> &mesh,
                   const DistinctCells &cells,
                   const std::vector<CellModel> &models,
                   const Element<dim, spacedim> &element,
                   const MaterialTable &materials);
} // namespace springfit

#endif
