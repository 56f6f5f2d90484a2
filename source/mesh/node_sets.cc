#include <springfit/mesh/connected_parts.h>
#include <springfit/mesh/mesh.h>
#include <springfit/mesh/node_sets.h>

namespace springfit
{
  template <int dim, int spacedim>
  NodeSets
  node_sets(const Mesh<dim, spacedim> &mesh)
  {
    const unsigned int n_nodes = mesh.nodes.size();
    NodeSets sets{{},
                  std::vector<std::set<unsigned int>>(n_nodes),
                  std::vector<std::set<unsigned int>>(n_nodes)};
    ConnectedParts parts(n_nodes);
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const auto &nodes = mesh.nodes.of(cell);
        for (const unsigned int node : nodes)
          {
            parts.connect(nodes.front(), node);
            sets.materials[node].insert(cell->material_id());
          }
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            for (const unsigned int a : mesh.nodes.of_faces[f])
              sets.boundaries[nodes[a]].insert(cell->face(f)->boundary_id());
      }
    sets.parts = parts.part_of_nodes();
    return sets;
  }

  template NodeSets
  node_sets(const Mesh<2> &);
  template NodeSets
  node_sets(const Mesh<2, 3> &);
  template NodeSets
  node_sets(const Mesh<3> &);
} // namespace springfit
