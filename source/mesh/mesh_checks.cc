#include <springfit/core/error.h>
#include <springfit/mesh/conformity.h>
#include <springfit/mesh/connected_parts.h>
#include <springfit/mesh/facets.h>
#include <springfit/mesh/mesh_checks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

namespace springfit
{
  namespace
  {
    // Below this, a corner's scaled Jacobian is rounding error.
    constexpr double flat = 1e-10;

    enum class Orientation
    {
      positive,
      negative,
      flat,
      folded
    };

    MeshPoint
    difference(const MeshPoint &a, const MeshPoint &b)
    {
      return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
    }

    double
    norm(const MeshPoint &a)
    {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }

    double
    scaled_determinant(const MeshPoint &a, const MeshPoint &b)
    {
      const double scale = norm(a) * norm(b);
      return scale > 0. ? (a[0] * b[1] - a[1] * b[0]) / scale : 0.;
    }

    double
    scaled_determinant(const MeshPoint &a,
                       const MeshPoint &b,
                       const MeshPoint &c)
    {
      const double scale = norm(a) * norm(b) * norm(c);
      return scale > 0. ? (a[0] * (b[1] * c[2] - b[2] * c[1]) +
                           a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0])) /
                            scale
                        : 0.;
    }

    Orientation
    orientation_of(const MeshDescription &mesh, const unsigned int cell)
    {
      const auto values = scaled_jacobians(mesh, cell);
      const double low  = *std::min_element(values.begin(), values.end());
      const double high = *std::max_element(values.begin(), values.end());
      if (low > flat)
        return Orientation::positive;
      if (high < -flat)
        return Orientation::negative;
      if (low < -flat && high > flat)
        return Orientation::folded;
      return Orientation::flat;
    }

    // The order that makes the mirror image of a cell.
    const std::vector<unsigned int> &
    mirrored_order(const CellKind kind)
    {
      static const std::map<CellKind, std::vector<unsigned int>> orders = {
        {CellKind::triangle, {0, 2, 1}},
        {CellKind::quadrilateral, {0, 2, 1, 3}},
        {CellKind::tetrahedron, {0, 2, 1, 3}},
        {CellKind::hexahedron, {4, 5, 6, 7, 0, 1, 2, 3}}};
      return orders.at(kind);
    }

    void
    mirror_numbering(MeshDescription &mesh, const unsigned int cell)
    {
      const auto &order   = mirrored_order(mesh.cell_kind);
      unsigned int *first = mesh.cell(cell);
      std::vector<unsigned int> old(first, first + order.size());
      for (unsigned int i = 0; i < order.size(); ++i)
        first[i] = old[order[i]];
    }

    std::string
    count(const unsigned int n, const MeshDescription &mesh)
    {
      return std::to_string(n) + " of " + std::to_string(mesh.n_cells()) +
             " cells " + (n == 1 ? "is" : "are");
    }

    /** First cell of each group and, at the end, the number of cells. */
    std::vector<unsigned int>
    group_limits(const MeshDescription &mesh)
    {
      std::vector<unsigned int> limits = mesh.group_begins;
      if (limits.empty())
        limits = {0};
      limits.push_back(mesh.n_cells());
      return limits;
    }

    void
    refuse(const MeshDescription &mesh,
           const std::vector<Orientation> &orientations,
           const Orientation bad,
           const std::string &text,
           const std::string &mend)
    {
      const auto first =
        std::find(orientations.begin(), orientations.end(), bad);
      if (first == orientations.end())
        return;
      const unsigned int n =
        std::count(orientations.begin(), orientations.end(), bad);
      throw InputError(mesh.name + ": " +
                         describe_cell(mesh, first - orientations.begin()) +
                         ' ' + text + " (" + count(n, mesh) + ").",
                       mend);
    }

    /** "x = 0.01, y = 0", in m. */
    std::string
    describe_place(const MeshDescription &mesh, const unsigned int vertex)
    {
      const MeshPoint &point = mesh.vertices[vertex];
      std::ostringstream text;
      text << "x = " << point[0] << ", y = " << point[1];
      if (dimension(mesh.cell_kind) == 3)
        text << ", z = " << point[2];
      return text.str();
    }

    /** The first ones only, in m. */
    std::string
    describe_places(const MeshDescription &mesh,
                    const std::vector<unsigned int> &vertices)
    {
      constexpr unsigned int n_named = 3;
      std::string text;
      for (unsigned int i = 0; i < vertices.size() && i < n_named; ++i)
        text += (i > 0 ? "; " : "") + describe_place(mesh, vertices[i]);
      return text + (vertices.size() > n_named ? "; ... (m)" : " (m)");
    }

    std::vector<unsigned int>
    part_of_vertices(const MeshDescription &mesh)
    {
      ConnectedParts parts(mesh.vertices.size());
      const int n_corners = n_vertices(mesh.cell_kind);
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (int i = 1; i < n_corners; ++i)
          parts.connect(mesh.cell(c)[0], mesh.cell(c)[i]);
      return parts.part_of_nodes();
    }

    /** One vertex of each position that has vertices of one part, or not. */
    std::vector<unsigned int>
    doubled_places(const MeshDescription &mesh,
                   const std::vector<std::vector<unsigned int>> &doubled,
                   const bool of_one_part)
    {
      if (doubled.empty())
        return {};
      const auto part_of = part_of_vertices(mesh);
      std::vector<unsigned int> places;
      for (const auto &group : doubled)
        if (of_one_part ==
            std::all_of(group.begin(), group.end(), [&](const unsigned int v) {
              return part_of[v] == part_of[group[0]];
            }))
          places.push_back(group[0]);
      return places;
    }

    std::string
    positions(const std::size_t n)
    {
      return std::to_string(n) + (n == 1 ? " position" : " positions");
    }

    const std::string how_to_merge =
      "merge them (in gmsh: 'Coherence Mesh;' in a .geo file that merges the "
      "mesh).";

    std::string
    warning_of_parts(const MeshDescription &mesh,
                     const std::vector<unsigned int> &n_cells,
                     const std::vector<unsigned int> &common_places)
    {
      constexpr unsigned int n_named = 8;
      std::vector<std::string> counts;
      for (unsigned int i = 0; i < n_cells.size() && i < n_named; ++i)
        counts.push_back(std::to_string(n_cells[i]));
      if (n_cells.size() > n_named)
        counts.push_back("...");
      const std::string text =
        mesh.name + " has " + std::to_string(n_cells.size()) +
        " parts without a common vertex, of " + join(counts) + " cells. ";
      if (common_places.empty())
        return text +
               "If they should hold together, mesh them as one body (in gmsh: "
               "Coherence, before meshing); none of their vertices coincide.";
      return text + "They touch with doubled vertices at " +
             positions(common_places.size()) + ": " +
             describe_places(mesh, common_places) +
             ". If they should hold together, " + how_to_merge;
    }

    std::string
    warning_of_doubled_vertices(const MeshDescription &mesh,
                                const std::vector<unsigned int> &places)
    {
      return mesh.name + " has doubled vertices at " +
             positions(places.size()) + ": " + describe_places(mesh, places) +
             ". Cells that touch there are not connected, so that the body "
             "opens or overlaps as at a crack. If this is no crack, " +
             how_to_merge;
    }

    std::string
    warning_of_hanging_vertices(const MeshDescription &mesh,
                                const std::vector<HangingVertex> &hanging)
    {
      std::vector<unsigned int> vertices;
      for (const HangingVertex &found : hanging)
        vertices.push_back(found.vertex);
      return mesh.name + " has " + std::to_string(vertices.size()) +
             (vertices.size() == 1 ? " vertex that hangs"
                                   : " vertices that hang") +
             " in a side of a cell without being its vertex: " +
             describe_places(mesh, vertices) + "; the first one in " +
             describe_cell(mesh, hanging[0].cell) +
             ". Cells that touch there are not connected, so that the body "
             "opens or overlaps. Mesh it anew, so that neighbours share whole "
             "sides: without half-refined cells, and parts as one body.";
    }
  } // namespace


  std::string
  describe_cell(const MeshDescription &mesh, const unsigned int cell)
  {
    const int n_corners = n_vertices(mesh.cell_kind);
    MeshPoint centre    = {{0., 0., 0.}};
    for (int i = 0; i < n_corners; ++i)
      for (int d = 0; d < 3; ++d)
        centre[d] += mesh.vertices[mesh.cell(cell)[i]][d] / n_corners;

    std::ostringstream text;
    text.precision(4);
    text << singular(mesh.cell_kind) << ' '
         << (mesh.cell_numbers.empty() ? cell : mesh.cell_numbers[cell])
         << " (around x = " << centre[0] << ", y = " << centre[1];
    if (dimension(mesh.cell_kind) == 3)
      text << ", z = " << centre[2];
    text << " m)";
    return text.str();
  }


  std::vector<double>
  scaled_jacobians(const MeshDescription &mesh, const unsigned int cell)
  {
    const unsigned int *const corners = mesh.cell(cell);
    const auto edge = [&](const unsigned int from, const unsigned int to) {
      return difference(mesh.vertices[corners[to]],
                        mesh.vertices[corners[from]]);
    };
    // In lexicographic order, flipping a bit goes to the neighbour along an
    // axis; all edges shall point the way of their axes.
    const auto axis = [&](const unsigned int corner, const unsigned int bit) {
      return edge(corner & ~bit, corner | bit);
    };

    // The tangent along an axis at the Gauss point nearest to a corner: the
    // four parallel edges, weighted by the linear functions across.
    const auto tangent_at_gauss = [&](const unsigned int corner,
                                      const unsigned int bit) {
      constexpr double near = 0.78867513459481288; // (1 + 1/sqrt(3)) / 2
      MeshPoint tangent{};
      for (unsigned int i = 0; i < 8; ++i)
        if ((i & bit) == 0)
          {
            double weight = 1.;
            for (const unsigned int across : {1u, 2u, 4u})
              if (across != bit)
                weight *= (i & across) == (corner & across) ? near : 1. - near;
            const MeshPoint e = axis(i, bit);
            for (unsigned int d = 0; d < 3; ++d)
              tangent[d] += weight * e[d];
          }
      return tangent;
    };

    std::vector<double> result;
    switch (mesh.cell_kind)
      {
        case CellKind::triangle:
          result.push_back(scaled_determinant(edge(0, 1), edge(0, 2)));
          break;
        case CellKind::tetrahedron:
          result.push_back(
            scaled_determinant(edge(0, 1), edge(0, 2), edge(0, 3)));
          break;
        case CellKind::quadrilateral:
          for (unsigned int i = 0; i < 4; ++i)
            result.push_back(scaled_determinant(axis(i, 1), axis(i, 2)));
          break;
        case CellKind::hexahedron:
          for (unsigned int i = 0; i < 8; ++i)
            {
              result.push_back(
                scaled_determinant(axis(i, 1), axis(i, 2), axis(i, 4)));
              // Good corners do not make a good inside.
              result.push_back(scaled_determinant(tangent_at_gauss(i, 1),
                                                  tangent_at_gauss(i, 2),
                                                  tangent_at_gauss(i, 4)));
            }
          break;
      }
    return result;
  }


  bool
  has_positive_jacobians(const MeshDescription &mesh, const unsigned int cell)
  {
    return orientation_of(mesh, cell) == Orientation::positive;
  }


  void
  check_not_empty(const MeshDescription &mesh)
  {
    if (mesh.cells.empty())
      throw InputError(mesh.name + " has no cells.",
                       "Give a mesh with at least one cell.");
  }


  void
  check_coordinates(const MeshDescription &mesh)
  {
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      for (const double x : mesh.vertices[v])
        if (!std::isfinite(x))
          throw InputError(mesh.name + ": the " + std::to_string(v + 1) +
                             ". vertex has a coordinate that is not a finite "
                             "number.",
                           "Write the mesh anew.");
  }


  void
  check_vertices_are_used(const MeshDescription &mesh)
  {
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const unsigned int v : mesh.cells)
      used.at(v) = true;
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end())
      throw InputError(mesh.name + ": the " +
                         std::to_string(unused - used.begin() + 1) +
                         ". vertex belongs to no cell.",
                       "Remove the vertices that no cell uses.");
  }


  void
  check_no_duplicate_cells(const MeshDescription &mesh)
  {
    const unsigned int n_corners = n_vertices(mesh.cell_kind);

    using Key = std::array<unsigned int, 9>; // the last one is the cell
    std::vector<Key> keys(mesh.n_cells(), Key{});
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      {
        std::copy_n(mesh.cell(c), n_corners, keys[c].begin());
        std::sort(keys[c].begin(), keys[c].begin() + n_corners);
        keys[c].back() = c;
      }
    std::sort(keys.begin(), keys.end());

    const auto twin =
      std::adjacent_find(keys.begin(),
                         keys.end(),
                         [](const Key &a, const Key &b) {
                           return std::equal(a.begin(), a.end() - 1, b.begin());
                         });
    if (twin != keys.end())
      throw InputError(mesh.name + ": " +
                         describe_cell(mesh, (twin + 1)->back()) +
                         " is a duplicate of " +
                         describe_cell(mesh, twin->back()) + ".",
                       "Remove one of them; a cell may belong to one physical "
                       "group of cells only.");
  }


  void
  check_orientation(MeshDescription &mesh)
  {
    std::vector<Orientation> orientations;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      orientations.push_back(orientation_of(mesh, c));

    const std::string measure =
      dimension(mesh.cell_kind) == 2 ? "area" : "volume";
    refuse(mesh,
           orientations,
           Orientation::flat,
           is_simplex(mesh.cell_kind)
             ? "has no " + measure
             : "is flat at one place at least, where its Jacobian is zero",
           "Move its vertices apart, or mesh the object anew.");
    refuse(mesh,
           orientations,
           Orientation::folded,
           "is folded: its Jacobian is negative at one place and positive "
           "at another",
           "Move its vertices until it is convex, or mesh the object anew.");

    const auto limits       = group_limits(mesh);
    unsigned int n_mirrored = 0;
    for (unsigned int g = 0; g + 1 < limits.size(); ++g)
      {
        const auto begin = orientations.begin() + limits[g];
        const auto end   = orientations.begin() + limits[g + 1];
        if (std::count(begin, end, Orientation::negative) != end - begin)
          continue;
        for (unsigned int c = limits[g]; c < limits[g + 1]; ++c)
          mirror_numbering(mesh, c);
        std::fill(begin, end, Orientation::positive);
        n_mirrored += end - begin;
      }

    refuse(mesh,
           orientations,
           Orientation::negative,
           "is inverted: its " + measure + " is negative",
           "Mesh the object anew, or order the vertices of such cells like "
           "those of the others.");
    if (n_mirrored > 0)
      mesh.warnings.push_back(mesh.name + ": " + count(n_mirrored, mesh) +
                              (dimension(mesh.cell_kind) == 2
                                 ? " numbered clockwise"
                                 : " numbered left-handedly") +
                              "; their vertices have been reordered.");
  }


  std::vector<unsigned int>
  connected_parts(const MeshDescription &mesh)
  {
    const auto part_of_vertex = part_of_vertices(mesh);
    std::vector<unsigned int> n_cells;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      {
        const unsigned int part = part_of_vertex[mesh.cell(c)[0]];
        if (part >= n_cells.size())
          n_cells.resize(part + 1, 0);
        ++n_cells[part];
      }
    return n_cells;
  }


  void
  check_connection(MeshDescription &mesh)
  {
    const auto parts = connected_parts(mesh);
    const auto found = nonconforming_vertices(mesh);
    if (parts.size() > 1)
      mesh.warnings.push_back(warning_of_parts(
        mesh, parts, doubled_places(mesh, found.doubled, false)));
    if (const auto places = doubled_places(mesh, found.doubled, true);
        !places.empty())
      mesh.warnings.push_back(warning_of_doubled_vertices(mesh, places));
    if (!found.hanging.empty())
      mesh.warnings.push_back(warning_of_hanging_vertices(mesh, found.hanging));
  }


  void
  check_mesh(MeshDescription &mesh)
  {
    check_not_empty(mesh);
    check_coordinates(mesh);
    check_vertices_are_used(mesh);
    check_no_duplicate_cells(mesh);
    check_orientation(mesh);
    check_connection(mesh);
  }
} // namespace springfit
