#ifndef springfit_mesh_nastran_file_h
#define springfit_mesh_nastran_file_h

#include <springfit/mesh/mesh_description.h>

#include <filesystem>
#include <string>

namespace springfit
{
  /**
   * Read a Nastran file (.bdf, .nas): GRID in the basic coordinate system, and
   * elements with their properties' numbers as ids of materials and, for those
   * on the boundary, of boundaries. Elements without area or volume are left
   * out with a warning, as are entries that say nothing of the mesh. Own,
   * because gmsh 4.8 passes over what it does not understand in silence, and
   * neither deal.II 9.4 nor VTK reads the format.
   *
   * @p name is what messages call the mesh; coordinates stay in the file's
   * units.
   *
   * @throws InputError with the line of what cannot be understood, of INCLUDE
   * and of nodes in other coordinate systems, and those of mesh_of_elements.
   */
  MeshDescription
  read_nastran_file(const std::filesystem::path &file,
                    const std::string &name,
                    int dim);
} // namespace springfit

#endif
