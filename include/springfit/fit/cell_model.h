#ifndef springfit_fit_cell_model_h
#define springfit_fit_cell_model_h

#include <springfit/springs/coupling.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace springfit
{
  /** The lumped forces of one cell: what a fit makes. */
  struct CellModel
  {
    /** One stiffness per spring of the cell, N/m */
    Eigen::VectorXd k;

    /** Between springs of the cell. */
    std::vector<LengthCoupling> couplings = {};

    /** N m, one per angle in cell_angles(); empty if the cell has none. */
    Eigen::VectorXd angle_stiffness = {};

    /**
     * Of the cell's volume spring, if it has one: N/m^5 in 3-d, of its area
     * N/m^3 in 2-d; see VolumeSpring.
     */
    std::optional<double> volume_stiffness = {};
  };

  bool
  all_finite(const CellModel &model);

  /** (1 - t) a + t b, of two models with the same springs, angles and volume.
   */
  CellModel
  between(const CellModel &a, const CellModel &b, double t);
} // namespace springfit

#endif
