#ifndef springfit_reference_quadratic_nodes_h
#define springfit_reference_quadratic_nodes_h

#include <springfit/mesh/mesh.h>

namespace springfit
{
  /** Those of the elements P2 or Q2 on a mesh. */
  template <int dim, int spacedim>
  Nodes<spacedim>
  quadratic_nodes(const Mesh<dim, spacedim> &mesh);
} // namespace springfit

#endif
