#include <springfit/mesh/conformity.h>
#include <springfit/mesh/connected_parts.h>
#include <springfit/mesh/edges.h>
#include <springfit/mesh/facets.h>

#include <Eigen/Dense>

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost's own
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace springfit
{
  namespace
  {
    // Of an edge or a side: what lies nearer is at the same place.
    constexpr double coincident = 1e-6;

    // Of the shortest edge at a vertex: a side that is further away may be the
    // next one of a thin cell.
    constexpr double much_nearer_than_a_neighbour = 1e-3;

    using Vector = Eigen::Vector3d;

    Vector
    position(const MeshDescription &mesh, const unsigned int vertex)
    {
      return Vector(mesh.vertices[vertex].data());
    }


    double
    distance_to_segment(const Vector &p, const Vector &a, const Vector &b)
    {
      const Vector edge   = b - a;
      const double square = edge.squaredNorm();
      const double t      = square > 0. ? edge.dot(p - a) / square : 0.;
      return (p - a - std::clamp(t, 0., 1.) * edge).norm();
    }

    double
    distance_to_triangle(const Vector &p,
                         const Vector &a,
                         const Vector &b,
                         const Vector &c)
    {
      const Vector normal = (b - a).cross(c - a);
      const auto is_left  = [&](const Vector &from, const Vector &to) {
        return (to - from).cross(p - from).dot(normal) >= 0.;
      };
      if (normal.squaredNorm() > 0. && is_left(a, b) && is_left(b, c) &&
          is_left(c, a))
        return std::abs(normal.normalized().dot(p - a));
      return std::min({distance_to_segment(p, a, b),
                       distance_to_segment(p, b, c),
                       distance_to_segment(p, c, a)});
    }

    using Corners = std::array<Vector, 4>; // in lexicographic order

    /**
     * From a point to that of a bilinear patch which Gauss's and Newton's
     * method finds from the middle: exact if the point is on the patch, else
     * never too small.
     */
    double
    distance_to_patch(const Vector &p, const Corners &q)
    {
      double s = 0.5, t = 0.5;
      Vector rest;
      for (unsigned int step = 0; step < 12; ++step)
        {
          rest = p - (1. - t) * ((1. - s) * q[0] + s * q[1]) -
                 t * ((1. - s) * q[2] + s * q[3]);
          const Vector along_s = (1. - t) * (q[1] - q[0]) + t * (q[3] - q[2]);
          const Vector along_t = (1. - s) * (q[2] - q[0]) + s * (q[3] - q[1]);
          const double ss = along_s.squaredNorm(), tt = along_t.squaredNorm(),
                       st          = along_s.dot(along_t),
                       determinant = ss * tt - st * st;
          if (!(determinant > 0.))
            break;
          const double on_s = along_s.dot(rest), on_t = along_t.dot(rest);
          s = std::clamp(s + (tt * on_s - st * on_t) / determinant, 0., 1.);
          t = std::clamp(t + (ss * on_t - st * on_s) / determinant, 0., 1.);
        }
      return rest.norm();
    }

    double
    distance_to_quadrilateral(const Vector &p, const Corners &q)
    {
      return std::min({distance_to_patch(p, q),
                       distance_to_triangle(p, q[0], q[1], q[2]),
                       distance_to_triangle(p, q[1], q[2], q[3]),
                       distance_to_triangle(p, q[0], q[1], q[3]),
                       distance_to_triangle(p, q[0], q[2], q[3])});
    }


    /** A side of a cell with its points. */
    struct Side
    {
      Side(const MeshDescription &mesh, const CellSide &place)
        : cell(place.cell)
      {
        for (const unsigned int i : sides_of(mesh.cell_kind)[place.side])
          points[n++] = position(mesh, mesh.cell(cell)[i]);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            diameter = std::max(diameter, (points[i] - points[j]).norm());
      }

      double
      distance(const Vector &p) const
      {
        return n == 2 ? distance_to_segment(p, points[0], points[1])
               : n == 3
                 ? distance_to_triangle(p, points[0], points[1], points[2])
                 : distance_to_quadrilateral(p, points);
      }

      double
      distance_to_vertices(const Vector &p) const
      {
        double smallest = (p - points[0]).norm();
        for (unsigned int i = 1; i < n; ++i)
          smallest = std::min(smallest, (p - points[i]).norm());
        return smallest;
      }

      unsigned int cell;
      Corners points;
      unsigned int n  = 0;
      double diameter = 0.;
    };


    /** The vertices on the boundary, found by boxes. */
    class BoundaryVertices
    {
    public:
      BoundaryVertices(const MeshDescription &mesh,
                       const std::vector<CellSide> &sides)
      {
        for (const CellSide &side : sides)
          for (const unsigned int i : sides_of(mesh.cell_kind)[side.side])
            vertices_.push_back(mesh.cell(side.cell)[i]);
        std::sort(vertices_.begin(), vertices_.end());
        vertices_.erase(std::unique(vertices_.begin(), vertices_.end()),
                        vertices_.end());

        std::vector<Entry> entries;
        entries.reserve(vertices_.size());
        for (const unsigned int v : vertices_)
          entries.emplace_back(point(position(mesh, v)), v);
        tree_ = Tree(entries); // all at once, which is n log n
      }

      /** In ascending order. */
      const std::vector<unsigned int> &
      all() const
      {
        return vertices_;
      }

      /** Call @p visit with each vertex in the box of the corners. */
      template <typename Visit>
      void
      visit_box(const Vector &lowest,
                const Vector &highest,
                const Visit &visit) const
      {
        const boost::geometry::model::box<Point> box(point(lowest),
                                                     point(highest));
        for (auto entry = tree_.qbegin(boost::geometry::index::intersects(box));
             entry != tree_.qend();
             ++entry)
          visit(entry->second);
      }

    private:
      using Point = boost::geometry::model::
        point<double, 3, boost::geometry::cs::cartesian>;
      using Entry = std::pair<Point, unsigned int>;
      using Tree =
        boost::geometry::index::rtree<Entry,
                                      boost::geometry::index::linear<16>>;

      static Point
      point(const Vector &p)
      {
        return {p[0], p[1], p[2]};
      }

      std::vector<unsigned int> vertices_;
      Tree tree_;
    };


    std::vector<std::vector<unsigned int>>
    doubled_vertices(const MeshDescription &mesh,
                     const std::vector<double> &edges,
                     const BoundaryVertices &boundary)
    {
      ConnectedParts places(mesh.vertices.size());
      std::vector<unsigned int> twins;
      for (const unsigned int v : boundary.all())
        {
          const Vector p     = position(mesh, v);
          const double reach = coincident * edges[v];
          const Vector box   = Vector::Constant(reach);
          boundary.visit_box(p - box, p + box, [&](const unsigned int w) {
            if (w == v || (position(mesh, w) - p).norm() >
                            std::min(reach, coincident * edges[w]))
              return;
            places.connect(v, w);
            twins.push_back(v);
          });
        }
      if (twins.empty())
        return {};

      twins.erase(std::unique(twins.begin(), twins.end()), twins.end());
      const auto place_of = places.part_of_nodes();
      std::map<unsigned int, std::vector<unsigned int>> groups;
      for (const unsigned int v : twins)
        groups[place_of[v]].push_back(v);
      std::vector<std::vector<unsigned int>> result;
      for (auto &group : groups)
        result.push_back(std::move(group.second));
      return result;
    }


    bool
    belongs_to_cell(const MeshDescription &mesh,
                    const unsigned int vertex,
                    const unsigned int cell)
    {
      const unsigned int *const first = mesh.cell(cell);
      const unsigned int *const end   = first + n_vertices(mesh.cell_kind);
      return std::find(first, end, vertex) != end;
    }

    std::vector<HangingVertex>
    hanging_vertices(const MeshDescription &mesh,
                     const std::vector<double> &edges,
                     const BoundaryVertices &boundary,
                     const std::vector<CellSide> &sides)
    {
      std::map<unsigned int, unsigned int> cell_of_vertex;
      for (const CellSide &place : sides)
        {
          const Side side(mesh, place);
          const double reach = coincident * side.diameter;
          Vector lowest = side.points[0], highest = side.points[0];
          for (unsigned int i = 1; i < side.n; ++i)
            {
              lowest  = lowest.cwiseMin(side.points[i]);
              highest = highest.cwiseMax(side.points[i]);
            }
          const Vector margin = Vector::Constant(reach);
          boundary.visit_box(
            lowest - margin, highest + margin, [&](const unsigned int v) {
              if (belongs_to_cell(mesh, v, side.cell))
                return;
              const Vector p = position(mesh, v);
              if (side.distance_to_vertices(p) > reach &&
                  side.distance(p) <=
                    std::min(reach, much_nearer_than_a_neighbour * edges[v]))
                cell_of_vertex.emplace(v, side.cell); // keeps the first
            });
        }

      std::vector<HangingVertex> result;
      for (const auto &[vertex, cell] : cell_of_vertex)
        result.push_back({vertex, cell});
      return result;
    }
  } // namespace


  NonconformingVertices
  nonconforming_vertices(const MeshDescription &mesh)
  {
    const auto sides = boundary_cell_sides(mesh);
    const auto edges = shortest_edges(mesh);
    const BoundaryVertices boundary(mesh, sides);
    return {doubled_vertices(mesh, edges, boundary),
            hanging_vertices(mesh, edges, boundary, sides)};
  }
} // namespace springfit
