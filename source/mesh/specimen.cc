#include <springfit/core/error.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/flat_sides.h>
#include <springfit/mesh/gmsh_model.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>
#include <springfit/mesh/specimen_outline.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// The boundary ids of the specimen, whose axis runs from the origin along x:
//
//             3 y max                             y
//      +-------.           .-------+              |
//      |        `---------'        |              |
//  0   |- - - - - axis - - - - - - |  1           +--- x
//      |        .---------.        |
//      +-------'           `-------+              in space: 4 z min below,
//             2 y min                             5 z max above

namespace springfit
{
  namespace
  {
    SpecimenOutline
    outline_of(const ObjectRequest &request)
    {
      return {request.size[0], request.size[1]};
    }

    // Where the outline is so wide, cells have the lengths asked for: the
    // harmonic mean of the widths of grip and gauge.
    double
    mean_width(const SpecimenOutline &outline)
    {
      return 0.5 * outline.width;
    }

    // Stations between which cells keep their proportions: the length of a
    // cell is as the width, so that equal parts of the integral of dx / width
    // lie between them. Each part of the outline has whole cells.
    void
    add_stations(const SpecimenOutline &outline,
                 const Interval &part,
                 const double cell_size,
                 std::vector<double> &stations)
    {
      constexpr unsigned int n_fine = 1000;
      const double step             = part.length() / n_fine;
      std::vector<double> integral  = {0.};
      for (unsigned int i = 0; i < n_fine; ++i)
        integral.push_back(
          integral.back() +
          step * mean_width(outline) /
            (2. * outline.half_width(part.lowest + step * (i + 0.5))));

      const unsigned int n = n_intervals(integral.back(), cell_size);
      for (unsigned int station = 0; station < n; ++station)
        {
          const double wanted = integral.back() * station / n;
          const auto above =
            std::upper_bound(integral.begin(), integral.end(), wanted);
          const auto below = above - 1;
          stations.push_back(part.lowest +
                             step * (below - integral.begin() +
                                     (wanted - *below) / (*above - *below)));
        }
    }

    std::vector<double>
    stations_along(const SpecimenOutline &outline, const double cell_size)
    {
      const auto joints = outline.joints();
      std::vector<double> stations;
      for (unsigned int part = 0; part + 1 < joints.size(); ++part)
        add_stations(outline,
                     {joints[part], joints[part + 1]},
                     cell_size,
                     stations);
      stations.push_back(joints.back());
      return stations;
    }

    MeshDescription
    structured_specimen(const ObjectRequest &request)
    {
      const SpecimenOutline outline = outline_of(request);
      const auto x = stations_along(outline, cell_size_along(request, 0));
      const unsigned int n_across =
        n_intervals(mean_width(outline), cell_size_along(request, 1));
      const double thickness = request.dim == 3 ? request.size[2] : 0.;
      const unsigned int n_through =
        request.dim == 3 ? n_intervals(thickness, cell_size_along(request, 2))
                         : 0;

      MeshDescription mesh;
      mesh.cell_kind = request.cell_kind;
      for (unsigned int k = 0; k <= n_through; ++k)
        for (unsigned int j = 0; j <= n_across; ++j)
          for (const double station : x)
            mesh.vertices.push_back(
              {{station,
                (2. * j / n_across - 1.) * outline.half_width(station),
                n_through > 0 ? thickness * (double(k) / n_through - 0.5)
                              : 0.}});

      const unsigned int row   = x.size();
      const unsigned int layer = row * (n_across + 1);
      for (unsigned int k = 0; k < std::max(1u, n_through); ++k)
        for (unsigned int j = 0; j < n_across; ++j)
          for (unsigned int i = 0; i + 1 < row; ++i)
            for (int corner = 0; corner < n_vertices(request.cell_kind);
                 ++corner)
              mesh.cells.push_back((i + (corner & 1)) +
                                   (j + (corner >> 1 & 1)) * row +
                                   (k + (corner >> 2)) * layer);
      mesh.material_ids.assign(mesh.n_cells(), 0);
      return mesh;
    }

    int
    add_point(const SpecimenOutline &outline,
              const double x,
              const double side,
              const double z)
    {
      return gmsh::model::occ::addPoint(x, side * outline.half_width(x), z);
    }

    // A spline through so many points is the outline to 1e-7 of the width.
    int
    add_transition(const SpecimenOutline &outline,
                   const double side,
                   const double z,
                   const Interval &part,
                   const int begin,
                   const int end)
    {
      constexpr unsigned int n = 64;
      std::vector<MeshPoint> between;
      for (unsigned int i = 1; i < n; ++i)
        {
          const double x = part.lowest + part.length() * i / n;
          between.push_back({{x, side * outline.half_width(x), z}});
        }
      return add_gmsh_spline(begin, between, end);
    }

    /** What gmsh knows of a side of the outline. */
    struct Side
    {
      std::vector<int> curves; // from x = 0 to the other end
      int first_point, last_point;
    };

    // @p side is -1 for the lower and 1 for the upper one.
    Side
    add_side(const SpecimenOutline &outline, const double side, const double z)
    {
      const auto joints = outline.joints();
      std::vector<int> points;
      for (const double x : joints)
        points.push_back(add_point(outline, x, side, z));

      Side result{{}, points.front(), points.back()};
      for (unsigned int part = 0; part + 1 < joints.size(); ++part)
        result.curves.push_back(
          part % 2 == 0
            ? gmsh::model::occ::addLine(points[part], points[part + 1])
            : add_transition(outline,
                             side,
                             z,
                             {joints[part], joints[part + 1]},
                             points[part],
                             points[part + 1]));
      return result;
    }

    int
    add_surface(const SpecimenOutline &outline, const double z)
    {
      const Side lower      = add_side(outline, -1., z);
      const Side upper      = add_side(outline, 1., z);
      std::vector<int> loop = lower.curves;
      loop.push_back(
        gmsh::model::occ::addLine(lower.last_point, upper.last_point));
      loop.insert(loop.end(), upper.curves.rbegin(), upper.curves.rend());
      loop.push_back(
        gmsh::model::occ::addLine(upper.first_point, lower.first_point));
      return gmsh::model::occ::addPlaneSurface(
        {gmsh::model::occ::addCurveLoop(loop)});
    }

    MeshDescription
    specimen_of_simplices(const ObjectRequest &request)
    {
      const double thickness = request.dim == 3 ? request.size[2] : 0.;
      const GmshSession gmsh_session;
      const int surface = add_surface(outline_of(request), -0.5 * thickness);
      if (request.dim == 3)
        {
          gmsh::vectorpair extruded;
          gmsh::model::occ::extrude({{2, surface}}, 0, 0, thickness, extruded);
        }
      gmsh::model::occ::synchronize();
      set_gmsh_cell_size(request.cell_size[0]);
      mesh_gmsh_model("The specimen", request.dim);
      return read_gmsh_cells("The specimen", request.dim).mesh;
    }

    // gmsh's vertices lie on the outline up to its spline's error.
    void
    snap_to_outline(MeshDescription &mesh, const SpecimenOutline &outline)
    {
      for (MeshPoint &vertex : mesh.vertices)
        {
          const double y = outline.half_width(vertex[0]);
          if (std::abs(std::abs(vertex[1]) - y) < 1e-6 * outline.width)
            vertex[1] = std::copysign(y, vertex[1]);
        }
    }

    void
    snap_to_sides(MeshDescription &mesh, const ObjectRequest &request)
    {
      const double length = request.size[0];
      for (const double x : {0., length})
        snap_to_plane(mesh, 0, x, length);
      if (request.dim == 3)
        for (const double z : {-0.5 * request.size[2], 0.5 * request.size[2]})
          snap_to_plane(mesh, 2, z, request.size[2]);
      snap_to_outline(mesh, outline_of(request));
    }

    // Somewhere on the straight part, a cell reaches from y min to y max.
    bool
    is_one_cell_wide(const MeshDescription &mesh,
                     const SpecimenOutline &outline)
    {
      constexpr double rounding = 1e-6;
      const Interval part       = outline.straight_part();
      const double side         = (0.5 - rounding) * outline.gauge_width();
      const auto is_on_part     = [&](const double x) {
        return x > part.lowest - rounding * outline.length &&
               x < part.highest + rounding * outline.length;
      };
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        {
          bool at_min = false, at_max = false;
          for (int i = 0; i < n_vertices(mesh.cell_kind); ++i)
            if (const MeshPoint &p = mesh.vertices[mesh.cell(c)[i]];
                is_on_part(p[0]))
              {
                at_min = at_min || p[1] < -side;
                at_max = at_max || p[1] > side;
              }
          if (at_min && at_max)
            return true;
        }
      return false;
    }

    void
    check_not_coarser(const double cell_size,
                      const double largest,
                      const std::string &direction,
                      const std::string &part)
    {
      constexpr double rounding = 1. + 1e-9;
      if (cell_size > rounding * largest)
        throw EntryError("Geometry/Cell size",
                         text_of(cell_size) + direction +
                           " is too coarse for " + part + ".",
                         "Give " + text_of(largest) + " (in m)" + direction +
                           " or less.");
    }

    unsigned int
    side_of(const std::vector<MeshPoint> &points, const ObjectRequest &request)
    {
      if (lie_in_plane(points, 0, 0.))
        return 0;
      if (lie_in_plane(points, 0, request.size[0]))
        return 1;
      if (request.dim == 3)
        for (const unsigned int end : {0u, 1u})
          if (lie_in_plane(points, 2, (end - 0.5) * request.size[2]))
            return 4 + end;
      return points.front()[1] < 0. ? 2 : 3;
    }
  } // namespace


  void
  check_specimen(const ObjectRequest &request)
  {
    check_sizes(request);

    // A transition needs four cells, and its narrow end a whole one.
    const SpecimenOutline outline = outline_of(request);
    const double along            = 0.25 * outline.transition_length();
    const double across           = outline.gauge_width();
    const std::string part        = "the specimen's transition from grip to "
                                    "straight part";
    if (request.cell_size.size() == 1)
      check_not_coarser(request.cell_size[0],
                        std::min(along, across),
                        "",
                        part);
    else
      {
        check_not_coarser(request.cell_size[0], along, " along x", part);
        check_not_coarser(request.cell_size[1], across, " along y", part);
      }
    if (request.cell_kind == CellKind::tetrahedron)
      check_not_coarser(request.cell_size[0],
                        request.size[2],
                        "",
                        "the specimen's thickness");
  }


  MeshDescription
  describe_specimen(const ObjectRequest &request)
  {
    MeshDescription mesh = is_simplex(request.cell_kind)
                             ? specimen_of_simplices(request)
                             : structured_specimen(request);
    mesh.name            = "The specimen";
    mesh.straight_part   = outline_of(request).straight_part();
    snap_to_sides(mesh, request);
    if (is_one_cell_wide(mesh, outline_of(request)))
      mesh.warnings.push_back(
        "The specimen's straight part, where E_out and nu_out are measured, "
        "is only one cell wide somewhere. A smaller Geometry/Cell size gives "
        "more.");
    label_boundary(mesh, [&](const std::vector<MeshPoint> &points) {
      return side_of(points, request);
    });
    mesh.boundary_names = names_of_sides(request.dim);
    return mesh;
  }
} // namespace springfit
