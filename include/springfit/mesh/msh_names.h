#ifndef springfit_mesh_msh_names_h
#define springfit_mesh_msh_names_h

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** A physical group to which a .msh file gives a name. */
  struct MshName
  {
    int dim;
    int number;
    std::string name;
  };

  /**
   * The section $PhysicalNames of a .msh file, text or binary; empty without
   * one. Lines that cannot be understood are left out: the file's reader
   * complains of them.
   */
  std::vector<MshName>
  names_in_msh(const std::filesystem::path &file);
} // namespace springfit

#endif
