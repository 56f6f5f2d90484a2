#ifndef springfit_mesh_materials_h
#define springfit_mesh_materials_h

#include <springfit/mesh/mesh.h>

#include <set>
#include <string>
#include <vector>

namespace springfit
{
  struct MaterialRow
  {
    dealii::types::material_id id;
    std::string name; // between commas if it has several, empty if none
    unsigned int n_cells;
    double measure; // m^3, or m^2 in 2-d
  };

  /** A row for each material id of the mesh, in ascending order. */
  template <int dim, int spacedim>
  std::vector<MaterialRow>
  material_table(const Mesh<dim, spacedim> &mesh);

  /**
   * The materials that a user names by a number or name.
   *
   * @p entry names the parameter in the error.
   *
   * @throws EntryError listing the materials of the mesh when it is absent or
   * ambiguous.
   */
  template <int dim, int spacedim>
  std::set<dealii::types::material_id>
  find_materials(const Mesh<dim, spacedim> &mesh,
                 const std::string &id_or_name,
                 const std::string &entry);

  /**
   * The table for the screen: a headline and a line for each row, in columns
   * material id : name : cells : volume (area in 2-d), each line ended.
   */
  template <int dim>
  std::string
  format_material_table(const std::vector<MaterialRow> &table);
} // namespace springfit

#endif
