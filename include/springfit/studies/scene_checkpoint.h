#ifndef springfit_studies_scene_checkpoint_h
#define springfit_studies_scene_checkpoint_h

#include <springfit/calibration/calibrated_network.h>
#include <springfit/motion/checkpoint.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** What a checkpoint must fit, so that a run can go on from it. */
  struct SceneIdentity
  {
    /** The values in force without those that do not change a motion. */
    std::string entries;

    /** Of the mesh and the springs, which the entries do not hold. */
    std::uint64_t sum_of_networks;
  };

  /** @param folder has the scene's used.prm */
  SceneIdentity
  identity_of_scene(const std::filesystem::path &folder,
                    const std::vector<CalibratedNetwork> &networks);

  void
  write_identity(const SceneIdentity &identity, CheckpointWriter &checkpoint);

  /**
   * Read what write_identity() wrote.
   *
   * @throws InputError naming what differs when it is another scene's.
   */
  void
  check_identity(const SceneIdentity &identity,
                 const std::filesystem::path &path,
                 CheckpointReader &checkpoint);
} // namespace springfit

#endif
