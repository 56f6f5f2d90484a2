#include <springfit/core/cell_kind.h>

namespace springfit
{
  const WordTable<CellKind> &
  cell_kind_words()
  {
    static const WordTable<CellKind> table = {
      {CellKind::triangle, "triangles"},
      {CellKind::quadrilateral, "quadrilaterals"},
      {CellKind::tetrahedron, "tetrahedra"},
      {CellKind::hexahedron, "hexahedra"}};
    return table;
  }

  std::string
  singular(const CellKind kind)
  {
    static const WordTable<CellKind> table = {
      {CellKind::triangle, "triangle"},
      {CellKind::quadrilateral, "quadrilateral"},
      {CellKind::tetrahedron, "tetrahedron"},
      {CellKind::hexahedron, "hexahedron"}};
    return word_of(table, kind);
  }

  int
  dimension(const CellKind kind)
  {
    return kind == CellKind::triangle || kind == CellKind::quadrilateral ? 2
                                                                         : 3;
  }

  int
  n_vertices(const CellKind kind)
  {
    switch (kind)
      {
        case CellKind::triangle:
          return 3;
        case CellKind::quadrilateral:
        case CellKind::tetrahedron:
          return 4;
        default:
          return 8;
      }
  }

  bool
  is_simplex(const CellKind kind)
  {
    return kind == CellKind::triangle || kind == CellKind::tetrahedron;
  }
} // namespace springfit
