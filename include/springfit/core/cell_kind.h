#ifndef springfit_core_cell_kind_h
#define springfit_core_cell_kind_h

#include <springfit/core/words.h>

namespace springfit
{
  /** The four cells that springfit knows: P1 on simplices, Q1 on the others. */
  enum class CellKind
  {
    triangle,
    quadrilateral,
    tetrahedron,
    hexahedron
  };

  /** The plural words of the entry `Geometry/Cells`. */
  const WordTable<CellKind> &
  cell_kind_words();

  /** "triangle", "quadrilateral", ... */
  std::string
  singular(CellKind kind);

  /** 2 or 3. */
  int
  dimension(CellKind kind);

  /** 3, 4, 4, 8. */
  int
  n_vertices(CellKind kind);

  bool
  is_simplex(CellKind kind);
} // namespace springfit

#endif
