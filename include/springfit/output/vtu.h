#ifndef springfit_output_vtu_h
#define springfit_output_vtu_h

#include <springfit/mesh/mesh.h>
#include <springfit/springs/network.h>

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /**
   * Values at the nodes of a mesh: a row per component, a column per node.
   * With as many components as the mesh has dimensions it is a vector.
   */
  struct NodalField
  {
    std::string name;
    Eigen::MatrixXd values;
  };

  /** The cells of a mesh with values at their nodes. */
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
   * index.
   */
  template <int dim, int spacedim>
  void
  write_mesh_vtu(const std::filesystem::path &path,
                 const Mesh<dim, spacedim> &mesh,
                 const std::vector<bool> &cells,
                 const std::vector<NodalField> &fields);

  /**
   * The springs of a network as lines with their stiffness "k" in N/m and
   * "rest_length" in m, and values at their nodes.
   */
  template <int dim>
  void
  write_springs_vtu(const std::filesystem::path &path,
                    const SpringNetwork &network,
                    const std::vector<NodalField> &fields);

  /** A series of files in the folder of @p path, each with its place in it. */
  void
  write_pvd(const std::filesystem::path &path,
            const std::vector<std::pair<double, std::string>> &files);
} // namespace springfit

#endif
