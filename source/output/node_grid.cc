#include <springfit/mesh/vertex_order.h>
#include <springfit/output/node_grid.h>

#include <cstddef>
#include <map>

namespace springfit
{
  namespace
  {
    Eigen::MatrixXd
    in_space(const Eigen::MatrixXd &vectors)
    {
      Eigen::MatrixXd result         = Eigen::MatrixXd::Zero(3, vectors.cols());
      result.topRows(vectors.rows()) = vectors;
      return result;
    }
  } // namespace

  UnstructuredGrid
  node_grid(const Eigen::MatrixXd &places,
            const std::vector<NodalField> &fields)
  {
    const int n_nodes = places.cols();
    Eigen::MatrixXi numbers(1, n_nodes);
    for (int node = 0; node < n_nodes; ++node)
      numbers(node) = node;

    UnstructuredGrid grid;
    grid.points = in_space(places);
    grid.point_data.push_back({"node", numbers});
    for (const auto &field : fields)
      grid.point_data.push_back({field.name,
                                 field.values.rows() == places.rows()
                                   ? in_space(field.values)
                                   : field.values});
    return grid;
  }

  void
  add_cell(UnstructuredGrid &grid,
           const CellKind kind,
           const std::vector<unsigned int> &nodes)
  {
    static const std::map<CellKind, VtkCell> types = {
      {CellKind::triangle, VtkCell::triangle},
      {CellKind::quadrilateral, VtkCell::quadrilateral},
      {CellKind::tetrahedron, VtkCell::tetrahedron},
      {CellKind::hexahedron, VtkCell::hexahedron}};
    const auto &position = order_around_faces(kind);
    std::vector<unsigned int> around(nodes.size());
    for (std::size_t v = 0; v < nodes.size(); ++v)
      around[position[v]] = nodes[v];
    add_cell(grid, types.at(kind), around);
  }
} // namespace springfit
