#ifndef springfit_exports_lammps_h
#define springfit_exports_lammps_h

#include <springfit/exports/exported_scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  // LAMMPS (tried with that of Debian 12, 7 January 2022): springs are bonds,
  // bond_style harmonic or, by the law biquadratic, class2; angles are
  // angle_style harmonic. Their energies have no factor 1/2.

  /** All but springs and angles, as parts of a sentence. */
  std::vector<std::string>
  not_in_lammps(const ExportedScene &scene);

  /** What of it is left out: the same. */
  std::vector<std::string>
  left_out_of_lammps(const ExportedScene &scene);

  /**
   * <name>.data with nodes and springs, <name>.lmp with what is held, the
   * forces, and a minimisation or a motion, which writes the places of the
   * nodes to <name>.dump. What LAMMPS does not hold is `fix others`, external.
   *
   * @throws RunError when a file cannot be written.
   */
  void
  write_lammps(const std::filesystem::path &folder, const ExportedScene &scene);

  /** The same as <name>_library, for a program that drives LAMMPS' library. */
  void
  write_lammps_library(const std::filesystem::path &folder,
                       const ExportedScene &scene);
} // namespace springfit

#endif
