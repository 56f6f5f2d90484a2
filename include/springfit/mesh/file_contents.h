#ifndef springfit_mesh_file_contents_h
#define springfit_mesh_file_contents_h

#include <filesystem>
#include <string>

namespace springfit
{
  /**
   * The ending that a file should have by how it begins, as ".msh"; empty if
   * that tells nothing. Each format has one ending here, ".bdf" for Nastran's
   * files and ".step" for those that may end in ".stp".
   */
  std::string
  ending_by_content(const std::filesystem::path &file);
} // namespace springfit

#endif
