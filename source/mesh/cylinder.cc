#include <springfit/core/error.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/flat_sides.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>

#include <gmsh.h>

#include <array>
#include <cmath>
#include <vector>

// The boundary ids of the cylinder, whose axis runs from the origin along x:
//
//            2 mantle               z
//         ______________            |
//        (              )           |
//  0 x min )- - axis - - ) 1 x max  +--- x
//        (______________)
//
// A layer of hexahedra is a disc of quadrilaterals: a block of n x n in the
// middle, and m rings of 4 n around it.

namespace springfit
{
  namespace
  {
    using PlanePoint = std::array<double, 2>;

    // Chosen so that the worst angles of the cells at the block's corners and
    // sides are as good as they get: where the block's corners lie on the
    // radius, and how far its sides bulge towards a circle.
    constexpr double corner_radius = 0.6;
    constexpr double bulge         = 0.4;

    /** Vertices, and cells in lexicographic numbering. */
    struct Disc
    {
      std::vector<PlanePoint> vertices;
      std::vector<std::array<unsigned int, 4>> cells;
    };

    // The point of the block at u, v in [-1, 1], on a disc of radius 1.
    PlanePoint
    block_point(const double u, const double v)
    {
      const double straight = (1. - bulge) / std::sqrt(2.);
      return {
        {corner_radius * u * (straight + bulge * std::sqrt(1. - 0.5 * v * v)),
         corner_radius * v * (straight + bulge * std::sqrt(1. - 0.5 * u * u))}};
    }

    // Positions i, j of the block's vertices around it, counter-clockwise.
    std::vector<std::array<unsigned int, 2>>
    block_rim(const unsigned int n)
    {
      std::vector<std::array<unsigned int, 2>> rim;
      for (unsigned int i = 0; i < n; ++i)
        rim.push_back({{i, 0}});
      for (unsigned int j = 0; j < n; ++j)
        rim.push_back({{n, j}});
      for (unsigned int i = n; i > 0; --i)
        rim.push_back({{i, n}});
      for (unsigned int j = n; j > 0; --j)
        rim.push_back({{0, j}});
      return rim;
    }

    void
    add_block(Disc &disc, const unsigned int n)
    {
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          disc.vertices.push_back(
            block_point(2. * i / n - 1., 2. * j / n - 1.));
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int first = j * (n + 1) + i;
            disc.cells.push_back(
              {{first, first + 1, first + n + 1, first + n + 2}});
          }
    }

    void
    add_rings(Disc &disc, const unsigned int n, const unsigned int m)
    {
      std::vector<unsigned int> inner;
      for (const auto &[i, j] : block_rim(n))
        inner.push_back(j * (n + 1) + i);
      const std::vector<unsigned int> rim = inner;

      const unsigned int n_around = 4 * n;
      for (unsigned int ring = 1; ring <= m; ++ring)
        {
          std::vector<unsigned int> outer;
          for (unsigned int a = 0; a < n_around; ++a)
            {
              // The block's first corner points to -3/4 pi.
              const double angle  = M_PI * (2. * a / n_around - 0.75);
              const double weight = double(ring) / m;
              const auto start    = disc.vertices[rim[a]];
              outer.push_back(disc.vertices.size());
              disc.vertices.push_back(
                {{(1. - weight) * start[0] + weight * std::cos(angle),
                  (1. - weight) * start[1] + weight * std::sin(angle)}});
            }
          for (unsigned int a = 0; a < n_around; ++a)
            {
              const unsigned int next = (a + 1) % n_around;
              disc.cells.push_back(
                {{outer[a], outer[next], inner[a], inner[next]}});
            }
          inner = outer;
        }
    }

    /** A disc of radius 1 of n^2 + 4 n m quadrilaterals. */
    Disc
    make_disc(const unsigned int n, const unsigned int m)
    {
      Disc disc;
      add_block(disc, n);
      add_rings(disc, n, m);
      return disc;
    }

    // The counts that give the cells about the lengths asked for along the
    // circle (in the mean of the block's side and the arc outside) and along
    // the radius (in the mean over the circle).
    Disc
    disc_of_request(const ObjectRequest &request)
    {
      const double radius = 0.5 * request.size[1];
      const double side   = 2. * block_point(1., 1.)[0];
      const double arc    = 0.5 * M_PI;
      const double depth  = 1. - 0.5 * (block_point(1., 0.)[0] + corner_radius);
      return make_disc(
        n_intervals(radius * 0.5 * (side + arc), cell_size_along(request, 1)),
        n_intervals(radius * depth, cell_size_along(request, 2)));
    }

    MeshDescription
    layers_of_hexahedra(const ObjectRequest &request)
    {
      const Disc disc = disc_of_request(request);
      const unsigned int n_layers =
        n_intervals(request.size[0], cell_size_along(request, 0));
      const double radius = 0.5 * request.size[1];

      MeshDescription mesh;
      mesh.cell_kind = CellKind::hexahedron;
      for (unsigned int layer = 0; layer <= n_layers; ++layer)
        for (const PlanePoint &point : disc.vertices)
          mesh.vertices.push_back({{request.size[0] * layer / n_layers,
                                    radius * point[0],
                                    radius * point[1]}});

      const unsigned int n_disc = disc.vertices.size();
      for (unsigned int layer = 0; layer < n_layers; ++layer)
        for (const auto &cell : disc.cells)
          for (const unsigned int level : {layer, layer + 1})
            for (const unsigned int v : cell)
              mesh.cells.push_back(level * n_disc + v);
      mesh.material_ids.assign(mesh.n_cells(), 0);
      return mesh;
    }

    MeshDescription
    cylinder_of_tetrahedra(const ObjectRequest &request)
    {
      const GmshSession gmsh_session;
      gmsh::model::occ::addCylinder(
        0, 0, 0, request.size[0], 0, 0, 0.5 * request.size[1]);
      gmsh::model::occ::synchronize();
      set_gmsh_cell_size(request.cell_size[0]);
      mesh_gmsh_model("The cylinder", 3);
      return read_gmsh_cells("The cylinder", 3).mesh;
    }

    unsigned int
    side_of(const std::vector<MeshPoint> &points, const double height)
    {
      return lie_in_plane(points, 0, 0.)       ? 0
             : lie_in_plane(points, 0, height) ? 1
                                               : 2;
    }
  } // namespace


  void
  check_cylinder(const ObjectRequest &request)
  {
    check_dimension(request, 3, "a cylinder");
    check_sizes(request);
    if (std::abs(request.size[1] - request.size[2]) > 1e-9 * request.size[1])
      throw EntryError("Geometry/Size",
                       "the second and the third length of a cylinder differ.",
                       "Give height, diameter, diameter (in m).");
  }


  MeshDescription
  describe_cylinder(const ObjectRequest &request)
  {
    MeshDescription mesh = is_simplex(request.cell_kind)
                             ? cylinder_of_tetrahedra(request)
                             : layers_of_hexahedra(request);
    mesh.name            = "The cylinder";
    for (const double end : {0., request.size[0]})
      snap_to_plane(mesh, 0, end, request.size[0]);
    label_boundary(mesh, [&](const std::vector<MeshPoint> &points) {
      return side_of(points, request.size[0]);
    });
    mesh.boundary_names = {{0, "x min"}, {1, "x max"}, {2, "mantle"}};
    return mesh;
  }
} // namespace springfit
