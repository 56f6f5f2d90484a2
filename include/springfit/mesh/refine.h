#ifndef springfit_mesh_refine_h
#define springfit_mesh_refine_h

#include <springfit/mesh/mesh.h>

namespace springfit
{
  /**
   * Divide each edge of a mesh of linear elements in two, each cell into 4
   * (dim = 2) or 8. Vertices keep their numbers; boundaries stay as flat as
   * they are.
   */
  template <int dim, int spacedim>
  void
  refine(Mesh<dim, spacedim> &mesh);
} // namespace springfit

#endif
