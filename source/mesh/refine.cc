#include <springfit/mesh/refine.h>

#include <deal.II/base/exceptions.h>

namespace springfit
{
  template <int dim, int spacedim>
  void
  refine(Mesh<dim, spacedim> &mesh)
  {
    Assert(mesh.nodes.degree == 1, dealii::ExcNotImplemented());
    mesh.triangulation.refine_global(1);
    mesh.nodes = vertices_as_nodes(mesh.triangulation);
  }

  template void
  refine(Mesh<2> &);
  template void
  refine(Mesh<2, 3> &);
  template void
  refine(Mesh<3> &);
} // namespace springfit
