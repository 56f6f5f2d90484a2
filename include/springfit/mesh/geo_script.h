#ifndef springfit_mesh_geo_script_h
#define springfit_mesh_geo_script_h

#include <filesystem>

namespace springfit
{
  /**
   * A .geo is a program, and gmsh runs it: look for commands that leave gmsh,
   * which would start other programs or end the reading without a word.
   * Comments and strings do not count. The files that it includes or merges are
   * looked at, too: scripts as this one, meshes of gmsh as announced_in_msh()
   * does, and so are the options that stand beside any of them (a.geo.opt).
   *
   * @throws InputError that names the file, the line and the command, or a file
   * that is not there or of which nothing is known; those of
   * announced_in_msh().
   */
  void
  check_geo_script(const std::filesystem::path &file);
} // namespace springfit

#endif
