#include <springfit/calibration/cell_network.h>
#include <springfit/core/error.h>
#include <springfit/response/region.h>
#include <springfit/studies/openings.h>

#include <algorithm>

namespace springfit
{
  namespace
  {
    template <typename Cell>
    std::vector<unsigned int>
    nodes_of(const Cell &cell)
    {
      std::vector<unsigned int> nodes;
      for (const unsigned int v : cell->vertex_indices())
        nodes.push_back(cell->vertex_index(v));
      return nodes;
    }
  } // namespace

  template <int dim, int spacedim>
  Remains
  everything(const Mesh<dim, spacedim> &mesh)
  {
    return {std::vector<bool>(mesh.triangulation.n_active_cells(), true),
            std::vector<bool>(mesh.triangulation.n_vertices(), false)};
  }

  template <int dim, int spacedim>
  Remains
  opened(const Opening &opening,
         const Mesh<dim, spacedim> &mesh,
         const Remains &before)
  {
    const std::string entry = "Dynamics/Openings";
    const Region<spacedim> region(opening.condition, entry);
    const auto &vertices = mesh.triangulation.get_vertices();
    std::vector<bool> is_inside(vertices.size());
    for (unsigned int v = 0; v < vertices.size(); ++v)
      is_inside[v] = region.contains(vertices[v]);

    Remains after = before;
    after.lost_nodes.assign(vertices.size(), true);
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const auto nodes = nodes_of(cell);
        const auto index = cell->active_cell_index();
        if (std::all_of(nodes.begin(), nodes.end(), [&](const unsigned int v) {
              return is_inside[v];
            }))
          after.cells[index] = false;
        if (after.cells[index])
          for (const unsigned int v : nodes)
            after.lost_nodes[v] = false;
      }
    const auto n_left = [](const Remains &remains) {
      return std::count(remains.cells.begin(), remains.cells.end(), true);
    };
    if (n_left(after) == n_left(before))
      throw EntryError(entry,
                       "no cell lies where " + opening.condition + '.',
                       "Lengths are in m, and all vertices of a cell must meet "
                       "the condition; widen it.");
    if (n_left(after) == 0)
      throw EntryError(entry,
                       "no cell is left after that where " + opening.condition +
                         '.',
                       "Lengths are in m; narrow the condition.");
    return after;
  }

  template <int dim, int spacedim>
  SpringNetwork
  opened(const CalibratedNetwork &network,
         const CalibratedScene<dim, spacedim> &calibrated,
         const DistinctCells &cells,
         const Remains &remains)
  {
    const auto &mesh = *calibrated.mesh;
    SpringNetwork left{network.network.nodes, {}, network.network.mass};
    if (network.scope == Scope::object)
      {
        std::vector<std::vector<unsigned int>> nodes;
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
          if (remains.cells[cell->active_cell_index()])
            nodes.push_back(nodes_of(cell));
        left.families = within(network.network.families, nodes);
        return left;
      }
    std::vector<CellModel> models;
    for (const auto &fit : network.cells)
      models.push_back(fit.result);
    left.families =
      assemble_network(
        mesh,
        cells,
        [&](const unsigned int c) {
          return remains.cells[c] ? &models[cells.copies[c].distinct] : nullptr;
        },
        calibrated.element,
        calibrated.materials)
        .families;
    return left;
  }

  template Remains
  everything(const Mesh<2> &);
  template Remains
  everything(const Mesh<2, 3> &);
  template Remains
  everything(const Mesh<3> &);
  template Remains
  opened(const Opening &, const Mesh<2> &, const Remains &);
  template Remains
  opened(const Opening &, const Mesh<2, 3> &, const Remains &);
  template Remains
  opened(const Opening &, const Mesh<3> &, const Remains &);
  template SpringNetwork
  opened(const CalibratedNetwork &,
         const CalibratedScene<2> &,
         const DistinctCells &,
         const Remains &);
  template SpringNetwork
  opened(const CalibratedNetwork &,
         const CalibratedScene<2, 3> &,
         const DistinctCells &,
         const Remains &);
  template SpringNetwork
  opened(const CalibratedNetwork &,
         const CalibratedScene<3> &,
         const DistinctCells &,
         const Remains &);
} // namespace springfit
