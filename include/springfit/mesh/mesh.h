#ifndef springfit_mesh_mesh_h
#define springfit_mesh_mesh_h

#include <springfit/core/cell_kind.h>
#include <springfit/mesh/interval.h>
#include <springfit/mesh/nodes.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * A checked mesh of one cell kind, lengths in m: a body, or cells of a lower
   * dimension in space, as deal.II understands @p dim and @p spacedim. Every
   * rank of a parallel run holds all of it; the cells' subdomain ids say which
   * rank works on which cell.
   *
   * Every vertex of the triangulation belongs to a cell, so a vertex index is
   * the number of a node, in tables as in vectors.
   */
  template <int dim, int spacedim = dim>
  struct Mesh
  {
    CellKind cell_kind;
    dealii::Triangulation<dim, spacedim> triangulation;

    /** What bears displacements: the vertices, unless elements are quadratic.
     */
    Nodes<spacedim> nodes;

    /**
     * Names of boundary ids and material ids, where there are any: an id may
     * have several names, and a name several ids.
     */
    std::multimap<dealii::types::boundary_id, std::string> boundary_names;
    std::multimap<dealii::types::material_id, std::string> material_names;

    /** Names of the file that are no boundary or no material, and why. */
    std::map<std::string, std::string> unused_boundary_names;
    std::map<std::string, std::string> unused_material_names;

    /** What a user should know about the mesh although it can be used. */
    std::vector<std::string> warnings;

    /** Which cells the user left out, if any: "120 of 1000 cells, ...". */
    std::string left_out;

    /**
     * Where along x the cross section is constant by design, so that a tensile
     * test measures there; of few objects only.
     */
    std::optional<Interval> straight_part;
  };
} // namespace springfit

#endif
