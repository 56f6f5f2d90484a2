#ifndef springfit_output_mesh_vtu_h
#define springfit_output_mesh_vtu_h

#include <springfit/mesh/mesh.h>
#include <springfit/output/node_grid.h>

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  // A mesh of linear cells for ParaView. The nodes are points that cells share,
  // with their numbers as "node".

  // @throws RunError as write_vtu() does.

  /**
   * The cells with their material ids as "material", and values at the nodes:
   * point p is node p, cell c the one of active cell index c.
   */
  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<NodalField> &fields);

  /** A number for each cell, by active cell index. */
  struct CellField
  {
    std::string name;
    Eigen::VectorXd values;
  };

  /** With numbers of the cells besides. */
  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<NodalField> &fields,
                 const std::vector<CellField> &cell_fields);

  /**
   * The same of some cells, of which @p cells has a flag each, by active cell
   * index, and their nodes.
   */
  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<bool> &cells,
                 const std::vector<NodalField> &fields);

  /**
   * The faces on the boundary (edges of cells of dimension 2) with their
   * boundary ids as "boundary", and their nodes.
   */
  template <int dim, int spacedim>
  void
  write_boundaries_vtu(const std::filesystem::path &path,
                       const Mesh<dim, spacedim> &mesh);
} // namespace springfit

#endif
