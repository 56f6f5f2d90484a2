#ifndef springfit_mesh_physical_groups_h
#define springfit_mesh_physical_groups_h

#include <springfit/mesh/gmsh_model.h>

#include <filesystem>

namespace springfit
{
  /**
   * Open a file in gmsh, so that each group of elements belongs to as few
   * physical groups as the file says. (The .msh formats 1 and 2 state a
   * physical group for each element, which gmsh's reader widens to the whole
   * of the surface that the element belongs to.)
   */
  void
  open_with_groups(const std::filesystem::path &file, int dim);

  /**
   * Material ids and names of @p cells from the physical groups of gmsh's
   * current model. Where no cell has a group, gmsh's numbers of surfaces or
   * volumes serve if there are several; otherwise cells without group get 0.
   */
  void
  read_materials(GmshCells &cells);

  /** The same for the boundary; elements inside are not regarded. */
  void
  read_boundaries(GmshCells &cells);
} // namespace springfit

#endif
