#ifndef springfit_mesh_msh_head_h
#define springfit_mesh_msh_head_h

#include <filesystem>
#include <string>

namespace springfit
{
  /** What a .msh file says of itself. */
  struct MshHead
  {
    /** As it stands there: "2.2"; "1" for a file that says nothing; empty for
     * one that is no mesh of gmsh. */
    std::string version;

    bool is_binary;
  };

  /** Look for the head, before which other sections may stand. */
  MshHead
  read_msh_head(const std::filesystem::path &file);
} // namespace springfit

#endif
