#ifndef springfit_mesh_cell_names_h
#define springfit_mesh_cell_names_h

#include <springfit/mesh/mesh_description.h>

#include <string>

namespace springfit
{
  /** "hexahedron 17 (around x = 0.01, y = 0, z = 0.2)", for messages. */
  std::string
  describe_cell(const MeshDescription &mesh, unsigned int cell);
} // namespace springfit

#endif
