#include <springfit/calibration/congruence.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/reference/cell_frame.h>

#include <map>
#include <unordered_map>

namespace springfit
{
  namespace
  {
    /** Sort the cells by material and by what @p shape_of makes of them. */
    template <int dim, int spacedim>
    DistinctCells
    sorted_cells(const Mesh<dim, spacedim> &mesh,
                 CanonicalShape (*shape_of)(const Eigen::MatrixXd &, CellKind))
    {
      DistinctCells cells;
      std::vector<CanonicalShape> shapes; // of the representatives
      std::map<dealii::types::material_id,
               std::unordered_map<ShapeKey, unsigned int>>
        known;

      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        {
          const auto shape =
            shape_of(flat_points<dim, spacedim>(cell), mesh.cell_kind);
          const auto [entry, is_new] =
            known[cell->material_id()].try_emplace(shape.key,
                                                   cells.distinct.size());
          const unsigned int distinct = entry->second;
          if (is_new)
            {
              cells.distinct.push_back(
                {cell->active_cell_index(), cell->material_id(), 0});
              shapes.push_back(shape);
            }
          ++cells.distinct[distinct].multiplicity;

          CellCopy copy;
          copy.distinct = distinct;
          copy.scale    = shape.size / shapes[distinct].size;
          copy.nodes.resize(shape.permutation.size());
          for (unsigned int v = 0; v < shape.permutation.size(); ++v)
            copy.nodes[shapes[distinct].permutation[v]] =
              cell->vertex_index(shape.permutation[v]);
          cells.copies.push_back(copy);
        }
      return cells;
    }
  } // namespace

  template <int dim, int spacedim>
  DistinctCells
  find_distinct_cells(const Mesh<dim, spacedim> &mesh)
  {
    return sorted_cells(mesh, &canonical_shape);
  }

  template <int dim, int spacedim>
  DistinctCells
  find_distinct_oriented_cells(const Mesh<dim, spacedim> &mesh)
  {
    return sorted_cells(mesh, &oriented_shape);
  }

  template <int dim, int spacedim>
  DistinctCells
  every_cell(const Mesh<dim, spacedim> &mesh)
  {
    DistinctCells cells;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const unsigned int index = cell->active_cell_index();
        cells.distinct.push_back({index, cell->material_id(), 1});
        cells.copies.push_back({index, {}, 1.});
        for (const unsigned int v : cell->vertex_indices())
          cells.copies.back().nodes.push_back(cell->vertex_index(v));
      }
    return cells;
  }

  template DistinctCells
  every_cell<2>(const Mesh<2> &);
  template DistinctCells
  every_cell<2, 3>(const Mesh<2, 3> &);
  template DistinctCells
  every_cell<3>(const Mesh<3> &);
  template DistinctCells
  find_distinct_cells<2>(const Mesh<2> &);
  template DistinctCells
  find_distinct_cells<2, 3>(const Mesh<2, 3> &);
  template DistinctCells
  find_distinct_cells<3>(const Mesh<3> &);
  template DistinctCells
  find_distinct_oriented_cells<2>(const Mesh<2> &);
  template DistinctCells
  find_distinct_oriented_cells<2, 3>(const Mesh<2, 3> &);
  template DistinctCells
  find_distinct_oriented_cells<3>(const Mesh<3> &);
} // namespace springfit
