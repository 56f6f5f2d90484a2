#include <springfit/mesh/facets.h>
#include <springfit/mesh/flat_sides.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <stdexcept>

// The boundary ids of the box, of which a rectangle has the first four:
//
//          3 y max                            z  y
//        +---------+                          | /
//        |         |    5 z max above,        |/
//  0     |         |  1                       +--- x
//  x min |         | x max
//        |         |    4 z min below
//        +---------+
//          2 y min

namespace springfit
{
  namespace
  {
    using Counts = std::array<unsigned int, 3>;

    Counts
    n_cells_along(const ObjectRequest &request)
    {
      Counts n = {{1, 1, 0}};
      for (int d = 0; d < request.dim; ++d)
        n[d] = n_intervals(request.size[d], cell_size_along(request, d));
      return n;
    }

    void
    add_vertices(MeshDescription &mesh,
                 const ObjectRequest &request,
                 const Counts &n)
    {
      const double height = request.dim == 3 ? request.size[2] : 0.;
      for (unsigned int k = 0; k <= n[2]; ++k)
        for (unsigned int j = 0; j <= n[1]; ++j)
          for (unsigned int i = 0; i <= n[0]; ++i)
            mesh.vertices.push_back({{request.size[0] * i / n[0],
                                      request.size[1] * j / n[1],
                                      n[2] > 0 ? height * k / n[2] : 0.}});
    }

    MeshDescription
    structured_box(const ObjectRequest &request)
    {
      const Counts n = n_cells_along(request);
      MeshDescription mesh;
      mesh.cell_kind = request.cell_kind;
      add_vertices(mesh, request, n);

      const unsigned int row   = n[0] + 1;
      const unsigned int layer = row * (n[1] + 1);
      for (unsigned int k = 0; k < std::max(1u, n[2]); ++k)
        for (unsigned int j = 0; j < n[1]; ++j)
          for (unsigned int i = 0; i < n[0]; ++i)
            for (int corner = 0; corner < n_vertices(request.cell_kind);
                 ++corner)
              mesh.cells.push_back((i + (corner & 1)) +
                                   (j + (corner >> 1 & 1)) * row +
                                   (k + (corner >> 2)) * layer);
      mesh.material_ids.assign(mesh.n_cells(), 0);
      return mesh;
    }

    MeshDescription
    box_of_simplices(const ObjectRequest &request)
    {
      const auto &size = request.size;
      const GmshSession gmsh_session;
      if (request.dim == 2)
        gmsh::model::occ::addRectangle(0, 0, 0, size[0], size[1]);
      else
        gmsh::model::occ::addBox(0, 0, 0, size[0], size[1], size[2]);
      gmsh::model::occ::synchronize();
      set_gmsh_cell_size(request.cell_size[0]);
      mesh_gmsh_model("The box", request.dim);
      return read_gmsh_cells("The box", request.dim).mesh;
    }

    void
    snap_to_sides(MeshDescription &mesh, const std::vector<double> &size)
    {
      for (unsigned int d = 0; d < size.size(); ++d)
        for (const double side : {0., size[d]})
          snap_to_plane(mesh, d, side, size[d]);
    }

    unsigned int
    side_of(const std::vector<MeshPoint> &points,
            const std::vector<double> &size)
    {
      for (unsigned int d = 0; d < size.size(); ++d)
        for (unsigned int end = 0; end < 2; ++end)
          if (lie_in_plane(points, d, end * size[d]))
            return 2 * d + end;
      throw std::logic_error("a boundary side of a box lies inside");
    }
  } // namespace


  void
  check_box(const ObjectRequest &request)
  {
    check_sizes(request);
  }


  MeshDescription
  describe_box(const ObjectRequest &request)
  {
    MeshDescription mesh = is_simplex(request.cell_kind)
                             ? box_of_simplices(request)
                             : structured_box(request);
    mesh.name            = "The box";
    snap_to_sides(mesh, request.size);
    label_boundary(mesh, [&](const std::vector<MeshPoint> &points) {
      return side_of(points, request.size);
    });

    mesh.boundary_names = names_of_sides(request.dim);
    return mesh;
  }
} // namespace springfit
