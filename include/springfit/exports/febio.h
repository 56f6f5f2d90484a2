#ifndef springfit_exports_febio_h
#define springfit_exports_febio_h

#include <springfit/exports/exported_scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  // FEBio, format 4.0: discrete elements of linear springs, whose rest lengths
  // are distances and whose stiffness is positive (FESpringMaterial.cpp).

  /** As parts of a sentence. */
  std::vector<std::string>
  not_in_febio(const ExportedScene &scene);

  /**
   * <name>.feb
   *
   * @throws RunError when the file cannot be written.
   */
  void
  write_febio(const std::filesystem::path &folder, const ExportedScene &scene);
} // namespace springfit

#endif
