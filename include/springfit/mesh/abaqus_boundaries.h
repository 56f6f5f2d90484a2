#ifndef springfit_mesh_abaqus_boundaries_h
#define springfit_mesh_abaqus_boundaries_h

#include <springfit/mesh/abaqus_cells.h>
#include <springfit/mesh/abaqus_model.h>

#include <set>
#include <string>

namespace springfit
{
  /**
   * Name the boundaries by the sets of nodes, the sets of elements that lie on
   * sides of cells, and the surfaces. Sets of cells are listed as unused names,
   * but for those of @p material_names (in capitals), which are materials.
   *
   * @throws InputError when a set or a surface names what is not there, and
   * those of label_boundary_groups.
   */
  void
  label_abaqus_boundaries(const AbaqusModel &model,
                          const std::set<std::string> &material_names,
                          AbaqusCells &cells);
} // namespace springfit

#endif
