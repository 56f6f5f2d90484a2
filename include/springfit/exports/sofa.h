#ifndef springfit_exports_sofa_h
#define springfit_exports_sofa_h

#include <springfit/exports/exported_scene.h>
#include <springfit/exports/formats.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  // SOFA: springs, and from 24.12 on quadratic volumes of tetrahedra, which are
  // springs of a state that a VolumeMapping makes from the nodes.

  /** As parts of a sentence. */
  std::vector<std::string>
  not_in_sofa(const ExportedScene &scene, SofaVersion version);

  /**
   * <name>.scn, whose motion comes to rest by damping where the scene has none
   * of its own.
   *
   * @throws RunError when the file cannot be written.
   */
  void
  write_sofa(const std::filesystem::path &folder,
             const ExportedScene &scene,
             SofaVersion version);
} // namespace springfit

#endif
