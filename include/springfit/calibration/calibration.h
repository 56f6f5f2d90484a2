#ifndef springfit_calibration_calibration_h
#define springfit_calibration_calibration_h

#include <springfit/calibration/calibrated_network.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/calibration/fit_section.h>
#include <springfit/core/session.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/reference/material_law.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /** Those that the fits tell apart: CalibratedNetwork::cells in their order.
   */
  template <int dim, int spacedim>
  DistinctCells
  cells_of_fits(const FitSection<spacedim> &section,
                const Mesh<dim, spacedim> &mesh);

  /**
   * For every distinct cell, the reference stiffness, the springs' gradients
   * and the fit; then the network of all cells. A network for each method and
   * each enrichment asked for that the method has. Warns where the assumptions
   * of a published method do not hold. Collective.
   *
   * @param responses displacements of the linear finite elements under the
   * scene's loads, one per column; needed where FitSection::needs_responses()
   * @param law of the finite elements in deformed states
   *
   * @throws EntryError as FitSection's checks of cells and states do.
   * @throws RunError when a fit fails or its certified gap exceeds the
   * tolerance, with the cell, its place and its shape quality.
   */
  template <int dim, int spacedim>
  std::vector<CalibratedNetwork>
  calibrate(const FitSection<spacedim> &section,
            const Mesh<dim, spacedim> &mesh,
            const Element<dim, spacedim> &element,
            const MaterialTable &materials,
            const Eigen::MatrixXd &responses,
            MaterialLaw law,
            Session &session);

  /**
   * The network of one method with one enrichment, of fits of cells, without a
   * word of warning. Collective.
   *
   * @throws RunError as calibrate() does.
   */
  template <int dim, int spacedim>
  CalibratedNetwork
  calibrate_row(const FitSection<spacedim> &section,
                const typename FitSection<spacedim>::Row &row,
                const Mesh<dim, spacedim> &mesh,
                const Element<dim, spacedim> &element,
                const MaterialTable &materials,
                MaterialLaw law,
                Session &session);
} // namespace springfit

#endif
