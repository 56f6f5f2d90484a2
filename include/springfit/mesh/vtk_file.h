#ifndef springfit_mesh_vtk_file_h
#define springfit_mesh_vtk_file_h

#include <springfit/mesh/mesh_description.h>

#include <filesystem>
#include <string>

namespace springfit
{
  /**
   * The mesh of a legacy VTK file (.vtk, versions 1 to 5.1, text or binary) of
   * the kind UNSTRUCTURED_GRID, in its own units. The cell array @p id_array
   * holds the ids of materials and boundaries; all are 0 if it is empty, and a
   * warning lists the arrays that there are. @p name becomes the mesh's.
   *
   * The reader is springfit's own: gmsh 4.8 reads neither version 5.1 nor cell
   * arrays, and crashes on wrong counts; deal.II 9.4 reads version 3 as text.
   *
   * @throws EntryError (Geometry/Material ids) when there is no such array, and
   * InputError with what cannot be understood, and those of mesh_of_elements.
   */
  MeshDescription
  read_vtk_file(const std::filesystem::path &file,
                const std::string &name,
                int dim,
                const std::string &id_array);
} // namespace springfit

#endif
