#ifndef springfit_mesh_unv_file_h
#define springfit_mesh_unv_file_h

#include <springfit/mesh/mesh_description.h>

#include <filesystem>
#include <string>

namespace springfit
{
  /**
   * Read an I-deas universal file (.unv), as Salome and gmsh write it: nodes
   * (data sets 2411, 781 and 15), elements (2412 and 780) and groups (2417,
   * 2429, 2430, 2432, 2435, 2452, 2467 and 2477). Groups of cells are
   * materials, groups of nodes and of sides are boundaries, both with their
   * name and number; without groups the elements' property numbers are the ids.
   * Springs, masses and the like are left out with a warning. Own, because
   * gmsh 4.8 crashes on damaged files and passes over groups of nodes, and
   * neither deal.II 9.4 (no names) nor VTK reads them.
   *
   * @p name is what messages call the mesh; coordinates stay in the file's
   * units, and a warning tells when it states (164) that these are not @p scale
   * m. Many files in mm state m, which therefore counts for nothing.
   *
   * @throws InputError with the line of what cannot be understood, and those of
   * mesh_of_elements and label_boundary_groups.
   */
  MeshDescription
  read_unv_file(const std::filesystem::path &file,
                const std::string &name,
                int dim,
                double scale);
} // namespace springfit

#endif
