#ifndef springfit_exports_mujoco_h
#define springfit_exports_mujoco_h

#include <springfit/exports/exported_scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  // MuJoCo (tried with 2.2.2): nodes are bodies that slide, springs are spatial
  // tendons, forces are actuators that do not heed their control.

  /** As parts of a sentence. */
  std::vector<std::string>
  not_in_mujoco(const ExportedScene &scene);

  /** What of it is left out: the same. */
  std::vector<std::string>
  left_out_of_mujoco(const ExportedScene &scene);

  /**
   * <name>.xml (MJCF), moving by symplectic Euler.
   *
   * @throws RunError when the file cannot be written.
   */
  void
  write_mujoco(const std::filesystem::path &folder, const ExportedScene &scene);
} // namespace springfit

#endif
