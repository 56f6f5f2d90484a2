#ifndef springfit_exports_gipsi_h
#define springfit_exports_gipsi_h

#include <springfit/exports/exported_scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  // GiPSi, the simulator of Natsupakpong and Cavusoglu (2010), by its format
  // MSD (cwru-mercis/GiPSi): whole nodes are held, and nothing is loaded.

  /** As parts of a sentence. */
  std::vector<std::string>
  not_in_gipsi(const ExportedScene &scene);

  /** What of it is left out: the same. */
  std::vector<std::string>
  left_out_of_gipsi(const ExportedScene &scene);

  /**
   * <name>.msd
   *
   * @throws RunError when the file cannot be written.
   */
  void
  write_gipsi(const std::filesystem::path &folder, const ExportedScene &scene);
} // namespace springfit

#endif
