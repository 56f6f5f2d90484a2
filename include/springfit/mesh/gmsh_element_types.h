#ifndef springfit_mesh_gmsh_element_types_h
#define springfit_mesh_gmsh_element_types_h

#include <cstddef>
#include <map>

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
} // namespace springfit

#endif
