#ifndef springfit_mesh_physical_groups_h
#define springfit_mesh_physical_groups_h

#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/msh_names.h>

#include <filesystem>
#include <vector>

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
   * @p names are those of the file, if it is a .msh: gmsh gives a name to one
   * group only.
   */
  void
  read_materials(GmshCells &cells, const std::vector<MshName> &names);

  /**
   * The same for the boundary, as label_boundary_groups() has it: a side may
   * belong to several groups.
   */
  void
  read_boundaries(GmshCells &cells, const std::vector<MshName> &names);
} // namespace springfit

#endif
