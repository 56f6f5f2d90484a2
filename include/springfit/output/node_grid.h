#ifndef springfit_output_node_grid_h
#define springfit_output_node_grid_h

#include <springfit/core/cell_kind.h>
#include <springfit/output/vtu_file.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * Values at nodes: a row per component, a column per node. With as many
   * components as the nodes have coordinates it is a vector.
   */
  struct NodalField
  {
    std::string name;
    Eigen::MatrixXd values;
  };

  /**
   * A grid of all nodes as points, with their numbers from 0 as "node" and the
   * values of the fields. In 2-d the z of places and vectors is 0. Cells are
   * still to come.
   *
   * @param places dim x n_nodes, m
   */
  UnstructuredGrid
  node_grid(const Eigen::MatrixXd &places,
            const std::vector<NodalField> &fields);

  /** @param nodes in deal.II's order */
  void
  add_cell(UnstructuredGrid &grid,
           CellKind kind,
           const std::vector<unsigned int> &nodes);
} // namespace springfit

#endif
