#ifndef springfit_mesh_geo_script_h
#define springfit_mesh_geo_script_h

#include <filesystem>

namespace springfit
{
  /**
   * A .geo is a program, and gmsh runs it: look for commands that leave gmsh,
   * which would start other programs or end the reading without a word.
   * Comments and strings do not count; scripts that it includes are looked at,
   * too, where their names are written out.
   *
   * @throws InputError that names the file, the line and the command.
   */
  void
  check_geo_script(const std::filesystem::path &file);
} // namespace springfit

#endif
