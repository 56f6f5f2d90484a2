#ifndef springfit_mesh_medit_file_h
#define springfit_mesh_medit_file_h

#include <springfit/mesh/mesh_description.h>

#include <filesystem>
#include <string>

namespace springfit
{
  /**
   * The mesh of a .mesh file (the text form of Medit's format, of Mmg and of
   * FreeFEM), in its own units; references of cells and of sides of the
   * boundary become material and boundary ids. @p name becomes the mesh's.
   *
   * The reader is springfit's own because gmsh 4.8 loses the first element when
   * the count stands on the line of its keyword, and the last ones of a file
   * that is cut short.
   *
   * @throws InputError with the line of what cannot be understood, and those of
   * mesh_of_elements.
   */
  MeshDescription
  read_medit_file(const std::filesystem::path &file,
                  const std::string &name,
                  int dim);
} // namespace springfit

#endif
