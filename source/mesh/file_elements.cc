#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/mesh/boundary_groups.h>
#include <springfit/mesh/file_elements.h>
#include <springfit/mesh/mesh_checks.h>
#include <springfit/mesh/vertex_order.h>

#include <algorithm>
#include <map>
#include <utility>

namespace springfit
{
  namespace
  {
    std::string
    found_in(const std::vector<FileElements> &elements, const int dim)
    {
      std::vector<std::string> found;
      for (const FileElements &of_type : elements)
        if (of_type.dim == dim && !of_type.numbers.empty())
          found.push_back(std::to_string(of_type.numbers.size()) +
                          " of type '" + of_type.type + "'");
      return join(found);
    }

    const FileElements &
    cells_of(const std::string &name,
             const int dim,
             const std::vector<FileElements> &elements)
    {
      std::vector<const FileElements *> cells;
      std::vector<std::string> all;
      for (const FileElements &of_type : elements)
        if (of_type.dim == dim && !of_type.numbers.empty())
          cells.push_back(&of_type);
      for (int d = 0; d <= 3; ++d)
        if (const std::string found = found_in(elements, d); !found.empty())
          all.push_back(found);

      const bool has_solids = dim == 2 && !found_in(elements, 3).empty();
      if (cells.empty() || has_solids)
        throw InputError(
          name +
            (has_solids ? std::string(" has cells of dimension 3")
                        : " has no cells of dimension " + std::to_string(dim)) +
            "; it has " + (all.empty() ? "no elements at all" : join(all)) +
            '.',
          all.empty()
            ? "Give a complete mesh."
            : advice_on_dimension(!found_in(elements, 3).empty()   ? 3
                                  : !found_in(elements, 2).empty() ? 2
                                                                   : 1));
      if (cells.size() > 1)
        throw InputError(name + " has mixed cell types: " +
                           found_in(elements, dim) + '.',
                         "Mesh the object with cells of one type.");
      if (!cells.front()->cell_kind)
        throw InputError(name + " has cells that springfit does not know: " +
                           found_in(elements, dim) + '.',
                         "Use cells of first order with straight edges: " +
                           join(words_of(cell_kind_words())) + '.');
      return *cells.front();
    }

    void
    count_others(const std::string &name,
                 const int dim,
                 const std::vector<FileElements> &elements,
                 MeshDescription &mesh)
    {
      std::vector<std::string> found;
      for (int d = 0; d < dim - 1; ++d)
        if (const std::string of_dim = found_in(elements, d); !of_dim.empty())
          found.push_back(of_dim);
      if (!found.empty())
        mesh.warnings.push_back(
          name + ": elements that are neither cells nor sides are left out: " +
          join(found) + '.');
    }

    using VertexOfNode = std::vector<std::optional<unsigned int>>;

    VertexOfNode
    number_vertices(const FileElements &cells,
                    const std::vector<MeshPoint> &points,
                    MeshDescription &mesh)
    {
      std::vector<bool> is_used(points.size(), false);
      for (const std::size_t node : cells.nodes)
        is_used[node] = true;
      VertexOfNode vertices(points.size());
      for (std::size_t node = 0; node < points.size(); ++node)
        if (is_used[node])
          {
            vertices[node] = mesh.vertices.size();
            mesh.vertices.push_back(points[node]);
          }
      if (mesh.vertices.size() < points.size())
        mesh.warnings.push_back(
          std::to_string(points.size() - mesh.vertices.size()) + " of the " +
          std::to_string(points.size()) +
          " nodes of the mesh belong to no cell and are left out; the others "
          "are numbered from 0 in the order of their numbers there.");
      return vertices;
    }
  } // namespace


  std::string
  advice_on_dimension(const int dim)
  {
    if (dim < 2)
      return "Give a mesh with cells, " + join(words_of(cell_kind_words())) +
             ": of lines alone there is no body.";
    return dim == 3
             ? "Set Dimension = 3 and Cells to tetrahedra or hexahedra, or "
               "give another mesh."
             : "Set Dimension = 2 for a plane body; or Dimension = 3 and "
               "Cells = triangles for a surface in space, which is a "
               "membrane; or give a mesh of the volume.";
  }


  MeshOfElements
  mesh_of_elements(const std::string &name,
                   const int dim,
                   const std::vector<MeshPoint> &points,
                   const std::vector<FileElements> &elements)
  {
    const FileElements &cells = cells_of(name, dim, elements);
    MeshDescription mesh;
    mesh.name           = name;
    mesh.cell_kind      = *cells.cell_kind;
    mesh.cell_numbers   = cells.numbers;
    mesh.material_ids   = cells.ids;
    const auto vertices = number_vertices(cells, points, mesh);
    const auto &order   = order_around_faces(mesh.cell_kind);
    for (std::size_t c = 0; c < cells.numbers.size(); ++c)
      for (const unsigned int i : order)
        mesh.cells.push_back(*vertices[cells.nodes[c * order.size() + i]]);
    check_no_duplicate_cells(mesh); // or sides would have three
    count_others(name, dim, elements, mesh);
    return {std::move(mesh), vertices};
  }


  void
  label_sides(MeshOfElements &result, const std::vector<FileElements> &elements)
  {
    const int dim = dimension(result.mesh.cell_kind);
    std::map<unsigned int, BoundaryGroup> groups;
    for (const FileElements &of_type : elements)
      for (std::size_t e = 0;
           of_type.dim == dim - 1 && e < of_type.numbers.size();
           ++e)
        {
          std::vector<unsigned int> side;
          for (unsigned int i = 0; i < of_type.n_nodes; ++i)
            if (const auto vertex =
                  result.vertex_of_node[of_type.nodes[e * of_type.n_nodes + i]])
              side.push_back(*vertex);
          std::sort(side.begin(), side.end());
          BoundaryGroup &group = groups[of_type.ids[e]];
          if (side.size() == of_type.n_nodes)
            group.sides.push_back(side);
          else
            ++group.n_sides_without_cell;
        }
    groups.erase(0); // as the sides that the file does not list
    std::vector<BoundaryGroup> all;
    for (auto &[id, group] : groups)
      {
        group.number = id;
        all.push_back(std::move(group));
      }
    label_boundary_groups(result.mesh, all);
  }
} // namespace springfit
