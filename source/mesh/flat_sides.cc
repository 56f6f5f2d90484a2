#include <springfit/mesh/flat_sides.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  void
  snap_to_plane(MeshDescription &mesh,
                const unsigned int direction,
                const double position,
                const double size)
  {
    for (MeshPoint &vertex : mesh.vertices)
      if (std::abs(vertex[direction] - position) < 1e-9 * size)
        vertex[direction] = position;
  }


  bool
  lie_in_plane(const std::vector<MeshPoint> &points,
               const unsigned int direction,
               const double position)
  {
    return std::all_of(points.begin(), points.end(), [&](const auto &p) {
      return p[direction] == position;
    });
  }


  std::multimap<unsigned int, std::string>
  names_of_sides(const int dim)
  {
    std::multimap<unsigned int, std::string> names;
    for (int d = 0; d < dim; ++d)
      {
        const std::string axis(1, "xyz"[d]);
        names.emplace(2 * d, axis + " min");
        names.emplace(2 * d + 1, axis + " max");
      }
    return names;
  }
} // namespace springfit
