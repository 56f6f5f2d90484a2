#ifndef springfit_studies_delivered_h
#define springfit_studies_delivered_h

#include <springfit/comparison/homogenised_tensor.h>
#include <springfit/response/load_case.h>
#include <springfit/studies/calibrated_scene.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * The material's constants as a tensile test along the pull of the canned
   * cases would find them, in plane strain those of the material in space;
   * nothing where nothing can be measured.
   *
   * @param forces of the tension, N, spacedim x n_nodes
   * @param displacement m, as they
   */
  template <int dim, int spacedim>
  std::optional<YoungPoisson>
  delivered(const Scene<spacedim> &scene,
            const CalibratedScene<dim, spacedim> &calibrated,
            const Loading &loading,
            const Eigen::MatrixXd &forces,
            const Eigen::MatrixXd &displacement);
} // namespace springfit

#endif
