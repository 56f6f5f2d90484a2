#ifndef springfit_mesh_node_sets_h
#define springfit_mesh_node_sets_h

#include <set>
#include <vector>

namespace springfit
{
  template <int dim, int spacedim>
  struct Mesh;

  /** To what each node of a mesh belongs. */
  struct NodeSets
  {
    /** The connected part, from 0 in the order of their first nodes. */
    std::vector<unsigned int> parts;

    /** The ids of its cells' materials and of its faces' boundaries. */
    std::vector<std::set<unsigned int>> materials, boundaries;
  };

  template <int dim, int spacedim>
  NodeSets
  node_sets(const Mesh<dim, spacedim> &mesh);
} // namespace springfit

#endif
