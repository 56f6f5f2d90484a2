#ifndef springfit_mesh_abaqus_materials_h
#define springfit_mesh_abaqus_materials_h

#include <springfit/mesh/abaqus_cells.h>
#include <springfit/mesh/abaqus_model.h>

#include <set>
#include <string>

namespace springfit
{
  /**
   * Give the cells their material ids and names: the section of a cell decides,
   * of several the last one, else the set of the cell's *ELEMENT. Returns the
   * names, in capitals.
   *
   * @throws InputError when a section names no set or one that is not there.
   */
  std::set<std::string>
  label_abaqus_materials(const AbaqusModel &model, AbaqusCells &cells);
} // namespace springfit

#endif
