#include <springfit/core/error.h>
#include <springfit/mesh/cell_names.h>
#include <springfit/mesh/cell_orientation.h>
#include <springfit/mesh/edges.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/jitter.h>
#include <springfit/mesh/sizes.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace springfit
{
  namespace
  {
    std::vector<bool>
    vertices_inside(const MeshDescription &mesh)
    {
      std::vector<bool> inside(mesh.vertices.size(), true);
      for (const auto &side : boundary_sides(mesh))
        for (const unsigned int v : side)
          inside[v] = false;
      return inside;
    }

    /** Uniform in [-1, 1]; the standard leaves its own distributions open. */
    double
    random_number(std::mt19937 &generator)
    {
      return 2. * generator() / std::mt19937::max() - 1.;
    }

    std::vector<unsigned int>
    cells_inside_out(const MeshDescription &mesh)
    {
      std::vector<unsigned int> cells;
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        if (!has_positive_jacobians(mesh, c))
          cells.push_back(c);
      return cells;
    }

    /** A whole number of hundredths below @p fraction that does no harm. */
    double
    harmless_fraction(const MeshDescription &mesh, const double fraction)
    {
      MeshDescription jittered = mesh;
      int good = 0, bad = std::ceil(100. * fraction);
      while (bad - good > 1)
        {
          const int middle  = (good + bad) / 2;
          jittered.vertices = jittered_vertices(mesh, 0.01 * middle);
          (cells_inside_out(jittered).empty() ? good : bad) = middle;
        }
      return 0.01 * good;
    }
  } // namespace


  std::vector<MeshPoint>
  jittered_vertices(const MeshDescription &mesh, const double fraction)
  {
    const int dim       = dimension(mesh.cell_kind);
    const auto shortest = shortest_edges(mesh);
    const auto inside   = vertices_inside(mesh);

    std::mt19937 generator;
    std::vector<MeshPoint> vertices = mesh.vertices;
    for (unsigned int v = 0; v < vertices.size(); ++v)
      if (inside[v])
        for (int d = 0; d < dim; ++d)
          vertices[v][d] += fraction * shortest[v] * random_number(generator);
    return vertices;
  }


  void
  jitter(MeshDescription &mesh, const double fraction)
  {
    MeshDescription jittered = mesh;
    jittered.vertices        = jittered_vertices(mesh, fraction);
    if (const auto bad = cells_inside_out(jittered); !bad.empty())
      {
        const double harmless = harmless_fraction(mesh, fraction);
        throw EntryError(
          "Geometry/Jitter",
          text_of(fraction) + " turns " + describe_cell(jittered, bad.front()) +
            " inside out or makes it flat (" + std::to_string(bad.size()) +
            " of " + std::to_string(mesh.n_cells()) + " cells).",
          harmless > 0.
            ? "Lower it to " + text_of(harmless) + ", which this mesh can bear."
            : "Lower it to less than " + text_of(std::min(fraction, 0.01)) +
                ", or leave it 0: this mesh can bear next to none.");
      }

    if (jittered.vertices == mesh.vertices && fraction > 0.)
      jittered.warnings.push_back(mesh.name + " has no vertex inside, so that "
                                              "Geometry/Jitter moves none.");
    mesh = std::move(jittered);
  }
} // namespace springfit
