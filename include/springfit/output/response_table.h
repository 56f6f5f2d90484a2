#ifndef springfit_output_response_table_h
#define springfit_output_response_table_h

#include <springfit/mesh/mesh.h>

#include <Eigen/Core>

#include <filesystem>
#include <vector>

namespace springfit
{
  /**
   * cells.csv: a row per cell with its nodes, counted from 0, in deal.II's
   * order (of quadrilaterals and hexahedra lexicographic, x fastest).
   */
  template <int dim, int spacedim>
  void
  write_cells(const std::filesystem::path &folder,
              const Mesh<dim, spacedim> &mesh);

  /**
   * A load case as numbers that read back as the same doubles: a row per node
   * with whether all of its components are held (0 or 1), its force in N and
   * its displacement in m, whether each component is held, and the force of the
   * supports on it in N (z = 0 in 2-d).
   *
   * @param held a flag per unknown, dim * v + d
   * @param forces, displacement, reactions dim x n_nodes
   */
  void
  write_response(const std::filesystem::path &path,
                 const std::vector<bool> &held,
                 const Eigen::MatrixXd &forces,
                 const Eigen::MatrixXd &displacement,
                 const Eigen::MatrixXd &reactions);
} // namespace springfit

#endif
