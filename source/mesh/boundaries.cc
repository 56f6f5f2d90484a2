#include <springfit/mesh/boundaries.h>
#include <springfit/mesh/name_lookup.h>

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>

#include <map>
#include <set>

namespace springfit
{
  namespace
  {
    double
    triangle_area(const dealii::Point<3> &a,
                  const dealii::Point<3> &b,
                  const dealii::Point<3> &c)
    {
      return 0.5 * dealii::cross_product_3d(b - a, c - a).norm();
    }

    // A warped quadrilateral has no area of its own (and deal.II refuses to
    // measure it): the mean of the two pairs of triangles that span it.
    double
    area_of(const dealii::Triangulation<3>::face_iterator &face)
    {
      const auto v = [&](const unsigned int i) { return face->vertex(i); };
      if (face->n_vertices() == 3)
        return triangle_area(v(0), v(1), v(2));
      return 0.5 * (triangle_area(v(0), v(1), v(3)) +
                    triangle_area(v(0), v(3), v(2)) +
                    triangle_area(v(0), v(1), v(2)) +
                    triangle_area(v(1), v(3), v(2)));
    }
  } // namespace


  template <int dim, int spacedim>
  std::vector<BoundaryRow>
  boundary_table(const Mesh<dim, spacedim> &mesh)
  {
    std::map<dealii::types::boundary_id, BoundaryRow> rows;
    for (const auto &face : mesh.triangulation.active_face_iterators())
      if (face->at_boundary())
        {
          const auto id = face->boundary_id();
          auto &row =
            rows.try_emplace(id, BoundaryRow{id, "", 0, 0.}).first->second;
          ++row.n_faces;
          if constexpr (dim == 2)
            row.area += face->vertex(0).distance(face->vertex(1));
          else
            row.area += area_of(face);
        }

    std::vector<BoundaryRow> table;
    for (const auto &[id, row] : rows)
      {
        table.push_back(row);
        table.back().name = joined_names(mesh.boundary_names, id);
      }
    return table;
  }


  template <int dim, int spacedim>
  std::set<dealii::types::boundary_id>
  find_boundaries(const Mesh<dim, spacedim> &mesh,
                  const std::vector<std::string> &ids_or_names,
                  const std::string &entry)
  {
    std::set<dealii::types::boundary_id> ids, result;
    for (const auto &face : mesh.triangulation.active_face_iterators())
      if (face->at_boundary())
        ids.insert(face->boundary_id());
    const auto known = ids_and_names(ids, mesh.boundary_names);
    for (const std::string &word : ids_or_names)
      result.merge(
        find_ids(known, mesh.unused_boundary_names, word, "boundary", entry));
    return result;
  }


  template <int dim>
  std::string
  format_boundary_table(const std::vector<BoundaryRow> &table)
  {
    std::vector<TableLine> lines;
    for (const BoundaryRow &row : table)
      lines.push_back({row.id, row.name, row.n_faces, row.area});
    return format_table({"boundary id",
                         "name",
                         dim == 2 ? "edges" : "faces",
                         dim == 2 ? "length [m]" : "area [m^2]"},
                        lines);
  }


  template std::vector<BoundaryRow>
  boundary_table(const Mesh<2> &);
  template std::vector<BoundaryRow>
  boundary_table(const Mesh<2, 3> &);
  template std::vector<BoundaryRow>
  boundary_table(const Mesh<3> &);
  template std::set<dealii::types::boundary_id>
  find_boundaries(const Mesh<2> &,
                  const std::vector<std::string> &,
                  const std::string &);
  template std::set<dealii::types::boundary_id>
  find_boundaries(const Mesh<2, 3> &,
                  const std::vector<std::string> &,
                  const std::string &);
  template std::set<dealii::types::boundary_id>
  find_boundaries(const Mesh<3> &,
                  const std::vector<std::string> &,
                  const std::string &);
  template std::string
  format_boundary_table<2>(const std::vector<BoundaryRow> &);
  template std::string
  format_boundary_table<3>(const std::vector<BoundaryRow> &);
} // namespace springfit
