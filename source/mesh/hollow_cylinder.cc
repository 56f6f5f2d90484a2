#include <springfit/core/error.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/flat_sides.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <vector>

// The boundary ids of the hollow cylinder: those of the cylinder, and the
// spherical hole in its middle.
//
//            2 mantle               z
//         ______________            |
//        (     ( )      )           |
//  0 x min )  ( 3 hole ) ) 1 x max  +--- x
//        (_____( )______)

namespace springfit
{
  namespace
  {
    double
    hole_radius(const ObjectRequest &request)
    {
      return 0.6 * 0.5 * request.size[1];
    }

    double
    distance_from_centre(const MeshPoint &point, const double height)
    {
      return std::hypot(point[0] - 0.5 * height, point[1], point[2]);
    }

    MeshDescription
    mesh_of_gmsh(const ObjectRequest &request)
    {
      const double height = request.size[0];
      const GmshSession gmsh_session;
      const int cylinder = gmsh::model::occ::addCylinder(
        0, 0, 0, height, 0, 0, 0.5 * request.size[1]);
      const int hole =
        gmsh::model::occ::addSphere(0.5 * height, 0, 0, hole_radius(request));
      gmsh::vectorpair result;
      std::vector<gmsh::vectorpair> origin;
      gmsh::model::occ::cut({{3, cylinder}}, {{3, hole}}, result, origin);
      gmsh::model::occ::synchronize();
      set_gmsh_cell_size(request.cell_size[0]);
      mesh_gmsh_model("The hollow cylinder", 3);
      return read_gmsh_cells("The hollow cylinder", 3).mesh;
    }

    unsigned int
    side_of(const std::vector<MeshPoint> &points, const ObjectRequest &request)
    {
      const double height = request.size[0];
      if (lie_in_plane(points, 0, 0.))
        return 0;
      if (lie_in_plane(points, 0, height))
        return 1;
      const double limit = (1. + 1e-6) * hole_radius(request);
      return std::all_of(points.begin(),
                         points.end(),
                         [&](const MeshPoint &p) {
                           return distance_from_centre(p, height) < limit;
                         })
               ? 3
               : 2;
    }
  } // namespace


  void
  check_hollow_cylinder(const ObjectRequest &request)
  {
    check_cylinder(request);
    if (request.cell_kind != CellKind::tetrahedron)
      throw EntryError("Geometry/Cells",
                       "a hollow cylinder has no mesh of " +
                         word_of(cell_kind_words(), request.cell_kind) + ".",
                       "Set it to tetrahedra.");

    // What the hole leaves of the height at each end.
    const double wall = 0.5 * request.size[0] - hole_radius(request);
    if (wall < 0.1 * hole_radius(request))
      throw EntryError("Geometry/Size",
                       "a height of " + text_of(request.size[0]) +
                         " m leaves no wall around the spherical hole of "
                         "radius " +
                         text_of(hole_radius(request)) +
                         " m (0.6 times the radius of the cylinder).",
                       "Give a height of at least " +
                         text_of(2.2 * hole_radius(request)) +
                         " m, or a smaller diameter.");
    const double largest = hole_radius(request);
    if (request.cell_size[0] > largest * (1. + 1e-9))
      throw EntryError("Geometry/Cell size",
                       text_of(request.cell_size[0]) +
                         " is larger than the radius of the spherical hole.",
                       "Give " + text_of(largest) + " (in m) or less.");
  }


  MeshDescription
  describe_hollow_cylinder(const ObjectRequest &request)
  {
    MeshDescription mesh = mesh_of_gmsh(request);
    for (const double end : {0., request.size[0]})
      snap_to_plane(mesh, 0, end, request.size[0]);
    label_boundary(mesh, [&](const std::vector<MeshPoint> &points) {
      return side_of(points, request);
    });
    mesh.boundary_names = {{0, "x min"},
                           {1, "x max"},
                           {2, "mantle"},
                           {3, "hole"}};
    return mesh;
  }
} // namespace springfit
