#include <springfit/core/error.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  namespace
  {
    /** All edges of length one; numbered as deal.II does. */
    std::vector<MeshPoint>
    regular_vertices(const CellKind kind)
    {
      const double height = std::sqrt(3.) / 2.; // of the triangle
      switch (kind)
        {
          case CellKind::triangle:
            return {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0.5, height, 0.}}};
          case CellKind::tetrahedron:
            return {{{0., 0., 0.}},
                    {{1., 0., 0.}},
                    {{0.5, height, 0.}},
                    {{0.5, height / 3., std::sqrt(2. / 3.)}}};
          default:
            std::vector<MeshPoint> vertices;
            for (int v = 0; v < n_vertices(kind); ++v)
              vertices.push_back(
                {{double(v & 1), double(v >> 1 & 1), double(v >> 2 & 1)}});
            return vertices;
        }
    }
  } // namespace


  void
  check_single_cell(const ObjectRequest &request)
  {
    check_lengths(request.size, "Geometry/Size");
    if (request.size.empty() ||
        std::any_of(request.size.begin(),
                    request.size.end(),
                    [&](const double size) { return size != request.size[0]; }))
      throw EntryError("Geometry/Size",
                       "a regular cell has one length for all of its edges.",
                       "Give one number in m; 'Object = box' with a 'Cell "
                       "size' as large makes a rectangular cell.");
  }


  MeshDescription
  describe_single_cell(const ObjectRequest &request)
  {
    MeshDescription mesh;
    mesh.name      = "The cell";
    mesh.cell_kind = request.cell_kind;
    mesh.vertices  = regular_vertices(request.cell_kind);
    for (MeshPoint &vertex : mesh.vertices)
      for (double &coordinate : vertex)
        coordinate *= request.size[0];
    for (int v = 0; v < n_vertices(request.cell_kind); ++v)
      mesh.cells.push_back(v);
    mesh.material_ids = {0};
    return mesh;
  }
} // namespace springfit
