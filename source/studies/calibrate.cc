#include <springfit/core/collective.h>
#include <springfit/output/network_vtu.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/network_exports.h>
#include <springfit/studies/study.h>

#include <vector>

namespace springfit
{
  template <int dim, int spacedim>
  void
  calibrate(const Scene<spacedim> &scene, Session &session)
  {
    auto calibrated = make_scene<dim, spacedim>(scene, session);
    const std::vector<bool> free(spacedim * calibrated.mesh->nodes.size(),
                                 false);
    calibrate_scene(scene, calibrated, free, {}, session);
    check_exports(scene, calibrated);
    session.skip("Equilibria", "a calibration loads nothing");

    run_on_root(session.communicator(), [&]() {
      for (const auto &network : calibrated.networks)
        write_network_vtu(session.draft(), network.name, network.network, {});
    });
    write_exports(scene, calibrated, session);
    session.say_at_the_end(
      "springs_<fit>.csv and nodes.csv are the model; open springs_" +
      calibrated.networks.front().name +
      ".vtu in ParaView and colour it by k.");
  }

  template void
  calibrate<2, 2>(const Scene<2> &, Session &);
  template void
  calibrate<2, 3>(const Scene<3> &, Session &);
  template void
  calibrate<3, 3>(const Scene<3> &, Session &);
} // namespace springfit
