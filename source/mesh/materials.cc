#include <springfit/mesh/materials.h>
#include <springfit/mesh/name_lookup.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>

#include <map>
#include <set>

namespace springfit
{
  template <int dim, int spacedim>
  std::vector<MaterialRow>
  material_table(const Mesh<dim, spacedim> &mesh)
  {
    std::map<dealii::types::material_id, MaterialRow> rows;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const auto id = cell->material_id();
        auto &row =
          rows.try_emplace(id, MaterialRow{id, "", 0, 0.}).first->second;
        ++row.n_cells;
        row.measure += cell->measure();
      }

    std::vector<MaterialRow> table;
    for (const auto &[id, row] : rows)
      {
        table.push_back(row);
        table.back().name = joined_names(mesh.material_names, id);
      }
    return table;
  }


  template <int dim, int spacedim>
  std::set<dealii::types::material_id>
  find_materials(const Mesh<dim, spacedim> &mesh,
                 const std::string &id_or_name,
                 const std::string &entry)
  {
    std::set<dealii::types::material_id> ids;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      ids.insert(cell->material_id());
    return find_ids(ids_and_names(ids, mesh.material_names),
                    mesh.unused_material_names,
                    id_or_name,
                    "material",
                    entry);
  }


  template <int dim>
  std::string
  format_material_table(const std::vector<MaterialRow> &table)
  {
    std::vector<TableLine> lines;
    for (const MaterialRow &row : table)
      lines.push_back({row.id, row.name, row.n_cells, row.measure});
    return format_table({"material id",
                         "name",
                         "cells",
                         dim == 2 ? "area [m^2]" : "volume [m^3]"},
                        lines);
  }


  template std::vector<MaterialRow>
  material_table(const Mesh<2> &);
  template std::vector<MaterialRow>
  material_table(const Mesh<2, 3> &);
  template std::vector<MaterialRow>
  material_table(const Mesh<3> &);
  template std::set<dealii::types::material_id>
  find_materials(const Mesh<2> &, const std::string &, const std::string &);
  template std::set<dealii::types::material_id>
  find_materials(const Mesh<2, 3> &, const std::string &, const std::string &);
  template std::set<dealii::types::material_id>
  find_materials(const Mesh<3> &, const std::string &, const std::string &);
  template std::string
  format_material_table<2>(const std::vector<MaterialRow> &);
  template std::string
  format_material_table<3>(const std::vector<MaterialRow> &);
} // namespace springfit
