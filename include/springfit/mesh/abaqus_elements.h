#ifndef springfit_mesh_abaqus_elements_h
#define springfit_mesh_abaqus_elements_h

#include <springfit/core/cell_kind.h>

#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What springfit needs to know about a type of Abaqus' elements. */
  struct AbaqusElementType
  {
    /** Of the shape: 1 for a line, 2 for an area, 3 for a volume. */
    int dim;
    unsigned int n_nodes;

    /** None if springfit has no such cells (second order, wedges, lines). */
    std::optional<CellKind> cell_kind;

    /** For each side S1, S2, ... the positions of its nodes. */
    std::vector<std::vector<unsigned int>> sides;
  };

  /**
   * The type of that name, in any case and with any letters for variants
   * behind it (C3D8R, CPS4I), or a null pointer if it is not known.
   */
  const AbaqusElementType *
  find_abaqus_element_type(const std::string &name);

  /**
   * Whether the type is one of springs, masses, dashpots, gaps, connectors and
   * the like: elements of no shape, of which a mesh takes no notice.
   */
  bool
  is_shapeless_abaqus_element(const std::string &name);
} // namespace springfit

#endif
