#ifndef springfit_mesh_build_mesh_h
#define springfit_mesh_build_mesh_h

#include <springfit/mesh/mesh.h>
#include <springfit/mesh/mesh_description.h>

#include <memory>

namespace springfit
{
  /**
   * deal.II's triangulation of a checked description. Vertex and cell indices
   * are the description's. The cells are shared among @p n_ranks ranks by
   * their subdomain ids, in the same way wherever it is called.
   */
  template <int dim, int spacedim = dim>
  std::unique_ptr<Mesh<dim, spacedim>>
  build_mesh(const MeshDescription &description, unsigned int n_ranks = 1);
} // namespace springfit

#endif
