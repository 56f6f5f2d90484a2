#ifndef springfit_exports_calculix_h
#define springfit_exports_calculix_h

#include <springfit/exports/exported_scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  // CalculiX (ccx 2.20): springs are elements SPRINGA, whose force is a
  // function of the elongation over the distance at rest.

  /** As parts of a sentence. */
  std::vector<std::string>
  not_in_calculix(const ExportedScene &scene);

  /** What of it is left out: the same. */
  std::vector<std::string>
  left_out_of_calculix(const ExportedScene &scene);

  /**
   * <name>.inp: an equilibrium with or without NLGEOM, or a motion by
   * *DYNAMIC, whose displacements are printed to <name>.dat.
   *
   * @throws RunError when a file cannot be written.
   */
  void
  write_calculix(const std::filesystem::path &folder,
                 const ExportedScene &scene);
} // namespace springfit

#endif
