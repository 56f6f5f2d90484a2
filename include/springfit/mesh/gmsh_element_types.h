#ifndef springfit_mesh_gmsh_element_types_h
#define springfit_mesh_gmsh_element_types_h

#include <springfit/mesh/mesh_text.h>

#include <cstddef>
#include <map>
#include <string>

namespace springfit
{
  struct GmshElementType
  {
    int dim;
    unsigned int n_nodes;
  };

  /** By gmsh's number (its reference manual, section "MSH file format"). */
  const std::map<std::size_t, GmshElementType> &
  gmsh_element_types();

  /**
   * The type of that number; null if gmsh 4.8 has it, but not the list.
   * @p what has it, for the message: "element 3".
   *
   * @throws InputError with @p place when gmsh has no such type.
   */
  const GmshElementType *
  find_gmsh_element_type(long number,
                         const std::string &what,
                         const TextPlace &place);
} // namespace springfit

#endif
