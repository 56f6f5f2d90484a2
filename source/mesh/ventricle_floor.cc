#include <springfit/core/error.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/objects.h>
#include <springfit/mesh/sizes.h>

#include <cmath>
#include <complex>
#include <string>
#include <vector>

// The floor of the third ventricle as Natsupakpong and Cavusoglu (2010,
// section 5) simulate it: a membrane of 558 nodes, 1050 triangles and 1607
// edges, which is a disc with 64 edges on its rim. Its shape was not published;
// here it is the bowl z = - depth (1 - rho^2) over an ellipse, whose nodes lie
// on rings about the lowest one:
//
//        y
//     .--|--.
//   (    |    )    rho = 1 on the rim, boundary 0, where z = 0
//  (     o-----)-- x
//   (         )
//     `-----'

namespace springfit
{
  namespace
  {
    /**
     * How many nodes the rings have, from the middle: as many more from ring to
     * ring as cells of about one size want.
     */
    std::vector<unsigned int>
    nodes_of_rings()
    {
      std::vector<unsigned int> n = {1};
      for (unsigned int ring = 1; ring <= 16; ++ring)
        n.push_back(4 * ring + (ring <= 13 ? 1 : 0));
      return n;
    }

    /** The angle of a node, each second ring turned by half an edge. */
    double
    angle(const unsigned int ring,
          const unsigned int node,
          const unsigned int n)
    {
      return 2. * M_PI * (node + (ring % 2 == 0 ? 0. : 0.5)) / n;
    }

    MeshPoint
    point_on_bowl(const std::vector<double> &size,
                  const double rho,
                  const double angle)
    {
      return {{0.5 * size[0] * rho * std::cos(angle),
               0.5 * size[1] * rho * std::sin(angle),
               -size[2] * (1. - rho * rho)}};
    }

    /** Nodes of a ring: the first one's number and how many there are. */
    struct Ring
    {
      unsigned int number, first, n;

      unsigned int
      node(const unsigned int i) const
      {
        return first + i % n;
      }

      /** In a circle, in units of the distance of two rings. */
      std::complex<double>
      place(const unsigned int i) const
      {
        return std::polar<double>(number, angle(number, i, n));
      }
    };

    /** Fill the band between two rings with triangles of short edges. */
    void
    add_band(const Ring &inside,
             const Ring &outside,
             std::vector<unsigned int> &cells)
    {
      const auto distance = [&](const unsigned int i, const unsigned int o) {
        return std::abs(inside.place(i) - outside.place(o));
      };
      unsigned int i = 0, o = 0;
      while (i < inside.n || o < outside.n)
        if (i == inside.n ||
            (o < outside.n && distance(i, o + 1) <= distance(i + 1, o)))
          {
            cells.insert(cells.end(),
                         {inside.node(i),
                          outside.node(o),
                          outside.node(o + 1)});
            ++o;
          }
        else
          {
            cells.insert(cells.end(),
                         {inside.node(i), outside.node(o), inside.node(i + 1)});
            ++i;
          }
    }
  } // namespace


  void
  check_ventricle_floor(const ObjectRequest &request)
  {
    if (request.spacedim != 3 || request.dim != 2)
      throw EntryError("Geometry/Object",
                       "the ventricle floor is a surface in space.",
                       "Set 'Dimension = 3' and 'Cells = triangles'.");
    check_lengths(request.size, "Geometry/Size");
    if (request.size.size() != 3)
      throw EntryError("Geometry/Size",
                       std::to_string(request.size.size()) +
                         " numbers are given for the ventricle floor.",
                       "Give its extents along x and y and its depth, in m.");
  }


  MeshDescription
  describe_ventricle_floor(const ObjectRequest &request)
  {
    const auto n_nodes = nodes_of_rings();
    MeshDescription mesh;
    mesh.name      = "The ventricle floor";
    mesh.cell_kind = CellKind::triangle;
    mesh.vertices.push_back(point_on_bowl(request.size, 0., 0.));
    for (unsigned int ring = 1; ring < n_nodes.size(); ++ring)
      for (unsigned int v = 0; v < n_nodes[ring]; ++v)
        mesh.vertices.push_back(
          point_on_bowl(request.size,
                        double(ring) / (n_nodes.size() - 1),
                        angle(ring, v, n_nodes[ring])));

    for (unsigned int v = 0; v < n_nodes[1]; ++v)
      mesh.cells.insert(mesh.cells.end(), {0, 1 + v, 1 + (v + 1) % n_nodes[1]});
    Ring inside{1, 1, n_nodes[1]};
    for (unsigned int number = 2; number < n_nodes.size(); ++number)
      {
        const Ring outside{number, inside.first + inside.n, n_nodes[number]};
        add_band(inside, outside, mesh.cells);
        inside = outside;
      }
    mesh.material_ids.assign(mesh.n_cells(), 0);
    label_boundary(mesh, [](const std::vector<MeshPoint> &) { return 0; });
    mesh.boundary_names = {{0, "rim"}};
    return mesh;
  }
} // namespace springfit
