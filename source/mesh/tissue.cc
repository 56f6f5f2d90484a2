#include <springfit/core/error.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>
#include <springfit/mesh/tissue_outline.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

// The boundary ids of the tissue, whose length is along x. Its ends are cut
// off by x = constant, so that their mean normals point along x.
//
//                 2 side
//       .:----------------------.:.        y
//   0  ( :                       : )  1    |
// x min `:.                      :/  x max +--- x
//          `---------------------
//                 2 side

namespace springfit
{
  namespace
  {
    // The part of the length that belongs to an end.
    constexpr double end_part = 0.05;

    TissueOutline
    outline_of(const ObjectRequest &request)
    {
      return {request.size[0], request.size[1]};
    }

    // A curve of gmsh through points of the outline between two angles.
    int
    add_curve(const TissueOutline &outline,
              const int first_point,
              const int last_point,
              const double first_angle,
              const double last_angle)
    {
      constexpr unsigned int n = 100;
      std::vector<MeshPoint> between;
      for (unsigned int i = 1; i < n; ++i)
        {
          const auto p =
            outline.point(first_angle + (last_angle - first_angle) * i / n);
          between.push_back({{p[0], p[1], 0.}});
        }
      return add_gmsh_spline(first_point, between, last_point);
    }

    void
    add_surface(const TissueOutline &outline)
    {
      // The cuts' x on the upper half, and the same x on the lower one.
      const double at_min = outline.upper_angle(end_part * outline.length);
      const double at_max =
        outline.upper_angle((1. - end_part) * outline.length);
      const auto lower_angle = [&](const double upper) {
        return 2. * M_PI - upper; // x is even in the angle
      };
      const std::vector<double> angles = {at_max,
                                          at_min,
                                          lower_angle(at_min),
                                          lower_angle(at_max)};

      std::vector<int> points, curves;
      for (const double angle : angles)
        {
          const auto p = outline.point(angle);
          points.push_back(gmsh::model::occ::addPoint(p[0], p[1], 0.));
        }
      for (unsigned int i = 0; i < 4; ++i)
        curves.push_back(
          add_curve(outline,
                    points[i],
                    points[(i + 1) % 4],
                    angles[i],
                    i < 3 ? angles[i + 1] : angles[0] + 2. * M_PI));
      gmsh::model::occ::addPlaneSurface(
        {gmsh::model::occ::addCurveLoop(curves)});
    }

    // gmsh's splines are not quite the outline.
    void
    snap_to_outline(MeshDescription &mesh, const TissueOutline &outline)
    {
      std::set<unsigned int> rim;
      for (const auto &side : boundary_sides(mesh))
        rim.insert(side.begin(), side.end());
      for (const unsigned int v : rim)
        {
          MeshPoint &vertex = mesh.vertices[v];
          const auto p =
            outline.point(outline.nearest_angle(vertex[0], vertex[1]));
          vertex = {{p[0], p[1], 0.}};
        }
    }

    unsigned int
    side_of(const std::vector<MeshPoint> &points, const double length)
    {
      const auto all = [&](const auto &condition) {
        return std::all_of(points.begin(), points.end(), condition);
      };
      const double end = (end_part + 1e-9) * length;
      if (all([&](const MeshPoint &p) { return p[0] < end; }))
        return 0;
      if (all([&](const MeshPoint &p) { return p[0] > length - end; }))
        return 1;
      return 2;
    }
  } // namespace


  void
  check_tissue(const ObjectRequest &request)
  {
    check_dimension(request, 2, "tissue");
    check_sizes(request);
    if (request.cell_size.size() != 1)
      throw EntryError("Geometry/Cell size",
                       std::to_string(request.cell_size.size()) +
                         " numbers are given for tissue, whose cells have no "
                         "directions.",
                       "Give one length in m.");
    const double largest = 0.25 * std::min(request.size[0], request.size[1]);
    if (request.cell_size[0] > largest * (1. + 1e-9))
      throw EntryError("Geometry/Cell size",
                       text_of(request.cell_size[0]) +
                         " is too coarse for the tissue's outline.",
                       "Give " + text_of(largest) + " (in m) or less.");
  }


  MeshDescription
  describe_tissue(const ObjectRequest &request)
  {
    const TissueOutline outline = outline_of(request);
    const GmshSession gmsh_session;
    add_surface(outline);
    gmsh::model::occ::synchronize();
    set_gmsh_cell_size(request.cell_size[0]);
    if (request.cell_kind == CellKind::quadrilateral)
      make_gmsh_quadrilaterals();
    mesh_gmsh_model("The tissue", 2);
    MeshDescription mesh = read_gmsh_cells("The tissue", 2).mesh;

    snap_to_outline(mesh, outline);
    label_boundary(mesh, [&](const std::vector<MeshPoint> &points) {
      return side_of(points, request.size[0]);
    });
    mesh.boundary_names = {{0, "x min"}, {1, "x max"}, {2, "side"}};
    return mesh;
  }
} // namespace springfit
