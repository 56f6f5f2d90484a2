#ifndef springfit_calibration_cell_network_h
#define springfit_calibration_cell_network_h

#include <springfit/calibration/cell_fits.h>
#include <springfit/springs/network.h>

#include <functional>

namespace springfit
{
  /** By active cell index; null for one without springs. */
  using ModelOfCell = std::function<const CellModel *(unsigned int cell)>;

  /**
   * The network of all cells, each a copy of a distinct cell with a model of
   * its own, whose constants are scaled to its size.
   */
  template <int dim, int spacedim>
  SpringNetwork
  assemble_network(const Mesh<dim, spacedim> &mesh,
                   const DistinctCells &cells,
                   const ModelOfCell &model_of_cell,
                   const Element<dim, spacedim> &element,
                   const MaterialTable &materials);

  /**
   * The families of a cell by itself.
   *
   * @param nodes places at rest of copy.nodes in their order, spacedim x n, m,
   * which is how the families number them
   */
  template <int dim, int spacedim>
  Families
  families_of_cell(const CellModel &model,
                   const CellCopy &copy,
                   const Eigen::MatrixXd &nodes);

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
