#ifndef springfit_mesh_boundaries_h
#define springfit_mesh_boundaries_h

#include <springfit/mesh/mesh.h>

#include <set>
#include <string>
#include <vector>

namespace springfit
{
  struct BoundaryRow
  {
    dealii::types::boundary_id id;
    std::string name; // between commas if it has several, empty if none
    unsigned int n_faces;
    double area; // m^2, or m in 2-d
  };

  /** A row for each boundary id of the mesh, in ascending order. */
  template <int dim, int spacedim>
  std::vector<BoundaryRow>
  boundary_table(const Mesh<dim, spacedim> &mesh);

  /**
   * The boundaries that a user names by numbers or names. No words, no ids.
   *
   * @p entry names the parameter in the error.
   *
   * @throws EntryError listing the boundaries of the mesh when one is absent or
   * ambiguous.
   */
  template <int dim, int spacedim>
  std::set<dealii::types::boundary_id>
  find_boundaries(const Mesh<dim, spacedim> &mesh,
                  const std::vector<std::string> &ids_or_names,
                  const std::string &entry);

  /**
   * The table for the screen: a headline and a line for each row, in columns
   * boundary id : name : faces : area, each line ended.
   */
  template <int dim>
  std::string
  format_boundary_table(const std::vector<BoundaryRow> &table);
} // namespace springfit

#endif
