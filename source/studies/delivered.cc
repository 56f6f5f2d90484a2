#include <springfit/comparison/delivered_constants.h>
#include <springfit/studies/delivered.h>

namespace springfit
{
  template <int dim, int spacedim>
  std::optional<YoungPoisson>
  delivered(const Scene<spacedim> &scene,
            const CalibratedScene<dim, spacedim> &calibrated,
            const Loading &loading,
            const Eigen::MatrixXd &forces,
            const Eigen::MatrixXd &displacement)
  {
    const auto apparent =
      delivered_constants(*calibrated.mesh,
                          calibrated.element,
                          loading.pull->axis,
                          displacement,
                          forces,
                          calibrated.materials.begin()->second.thickness);
    if (apparent && spacedim == 2 &&
        scene.material.plane_state() == PlaneState::strain)
      return from_plane_strain(*apparent);
    return apparent;
  }

  template std::optional<YoungPoisson>
  delivered(const Scene<2> &,
            const CalibratedScene<2> &,
            const Loading &,
            const Eigen::MatrixXd &,
            const Eigen::MatrixXd &);
  template std::optional<YoungPoisson>
  delivered(const Scene<3> &,
            const CalibratedScene<2, 3> &,
            const Loading &,
            const Eigen::MatrixXd &,
            const Eigen::MatrixXd &);
  template std::optional<YoungPoisson>
  delivered(const Scene<3> &,
            const CalibratedScene<3> &,
            const Loading &,
            const Eigen::MatrixXd &,
            const Eigen::MatrixXd &);
} // namespace springfit
