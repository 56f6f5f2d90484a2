#include <springfit/core/error.h>
#include <springfit/mesh/connected_parts.h>
#include <springfit/response/rigid_motion.h>
#include <springfit/response/supports.h>

#include <algorithm>
#include <set>

namespace springfit
{
  namespace
  {
    /** The nodes of each part, parts being cells joined by faces. */
    template <int dim, int spacedim>
    std::vector<std::set<unsigned int>>
    nodes_of_parts(const dealii::Triangulation<dim, spacedim> &triangulation)
    {
      ConnectedParts parts(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f))
            parts.connect(cell->active_cell_index(),
                          cell->neighbor(f)->active_cell_index());
      const auto part_of_cells = parts.part_of_nodes();

      std::vector<std::set<unsigned int>> nodes(
        1 + *std::max_element(part_of_cells.begin(), part_of_cells.end()));
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          nodes[part_of_cells[cell->active_cell_index()]].insert(
            cell->vertex_index(v));
      return nodes;
    }

    /** The supports of a part's nodes. */
    struct HeldPoints
    {
      Eigen::MatrixXd points; // dim x n, m
      HeldComponents held;
    };

    template <int dim>
    HeldPoints
    held_points(const std::set<unsigned int> &nodes,
                const std::vector<bool> &held,
                const std::vector<dealii::Point<dim>> &vertices)
    {
      std::vector<unsigned int> selected;
      for (const unsigned int v : nodes)
        for (int d = 0; d < dim; ++d)
          if (held[dim * v + d])
            {
              selected.push_back(v);
              break;
            }
      HeldPoints result{Eigen::MatrixXd(dim, selected.size()),
                        HeldComponents(dim, selected.size())};
      for (unsigned int s = 0; s < selected.size(); ++s)
        for (int d = 0; d < dim; ++d)
          {
            result.points(d, s) = vertices[selected[s]][d];
            result.held(d, s)   = held[dim * selected[s] + d];
          }
      return result;
    }

    template <int dim>
    std::string
    motion_left(const std::set<unsigned int> &nodes,
                const std::vector<bool> &held,
                const std::vector<dealii::Point<dim>> &vertices)
    {
      const auto [points, components] = held_points<dim>(nodes, held, vertices);
      return free_rigid_motion(points, components);
    }

    template <int dim>
    unsigned int
    n_held(const std::set<unsigned int> &nodes, const std::vector<bool> &held)
    {
      unsigned int n = 0;
      for (const unsigned int v : nodes)
        n += std::find(held.begin() + dim * v,
                       held.begin() + dim * (v + 1),
                       true) != held.begin() + dim * (v + 1);
      return n;
    }
  } // namespace

  template <int dim, int spacedim>
  void
  check_supports(const Mesh<dim, spacedim> &mesh,
                 const std::vector<bool> &held,
                 const std::string &entry)
  {
    const auto &vertices = mesh.triangulation.get_vertices();
    const auto parts     = nodes_of_parts(mesh.triangulation);

    // Parts that are held hold their neighbours, until nothing changes.
    std::vector<bool> held_by_all = held;
    std::vector<bool> part_is_held(parts.size(), false);
    for (bool changed = true; changed;)
      {
        changed = false;
        for (unsigned int p = 0; p < parts.size(); ++p)
          if (!part_is_held[p] &&
              motion_left<spacedim>(parts[p], held_by_all, vertices).empty())
            {
              part_is_held[p] = true;
              changed         = true;
              for (const unsigned int v : parts[p])
                for (int d = 0; d < spacedim; ++d)
                  held_by_all[spacedim * v + d] = true;
            }
      }

    for (unsigned int p = 0; p < parts.size(); ++p)
      if (!part_is_held[p])
        {
          const unsigned int n = n_held<spacedim>(parts[p], held);
          throw EntryError(
            entry,
            "the supports (" + std::to_string(n) + " fixed node" +
              (n == 1 ? "" : "s") + ") leave " +
              (parts.size() == 1
                 ? "the object"
                 : "part " + std::to_string(p + 1) + " of the " +
                     std::to_string(parts.size()) +
                     " parts of the mesh that no common face connects") +
              (n_held<spacedim>(parts[p], held_by_all) > n
                 ? ", hinged to the others,"
                 : "") +
              " free: " +
              motion_left<spacedim>(parts[p], held_by_all, vertices) + '.',
            "Fix " +
              std::string(spacedim == 2
                            ? "two nodes"
                            : "three nodes that are not on a line") +
              " at least of each part, by 'Fixed boundaries', 'Fixed region' "
              "or 'Supports', or connect the parts by faces; or leave a part that "
              "is a material of its own out of the model, by 'Leave out' in "
              "section Geometry.");
        }
  }

  template void
  check_supports<2>(const Mesh<2> &,
                    const std::vector<bool> &,
                    const std::string &);
  template void
  check_supports<2, 3>(const Mesh<2, 3> &,
                       const std::vector<bool> &,
                       const std::string &);
  template void
  check_supports<3>(const Mesh<3> &,
                    const std::vector<bool> &,
                    const std::string &);
} // namespace springfit
