#include <springfit/mesh/vertex_order.h>

#include <map>

namespace springfit
{
  const std::vector<unsigned int> &
  order_around_faces(const CellKind kind)
  {
    static const std::map<CellKind, std::vector<unsigned int>> orders = {
      {CellKind::triangle, {0, 1, 2}},
      {CellKind::quadrilateral, {0, 1, 3, 2}},
      {CellKind::tetrahedron, {0, 1, 2, 3}},
      {CellKind::hexahedron, {0, 1, 3, 2, 4, 5, 7, 6}}};
    return orders.at(kind);
  }
} // namespace springfit
