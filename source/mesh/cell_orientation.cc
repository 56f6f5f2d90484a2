#include <springfit/core/error.h>
#include <springfit/mesh/cell_names.h>
#include <springfit/mesh/cell_orientation.h>

#include <algorithm>
#include <cmath>
#include <map>
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
  } // namespace


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
} // namespace springfit
