#include <springfit/calibration/shape_quality.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace springfit
{
  namespace
  {
    /** The ends of the edges that leave corner @p v, right-handed. */
    std::vector<int>
    neighbours(const CellKind kind, const int v)
    {
      switch (kind)
        {
          case CellKind::triangle:
            return {(v + 1) % 3, (v + 2) % 3};
          case CellKind::tetrahedron:
            // Even permutations of (v, the others) keep the orientation.
            return v % 2 == 0
                     ? std::vector<int>{(v + 1) % 4, (v + 2) % 4, (v + 3) % 4}
                     : std::vector<int>{(v + 1) % 4, (v + 3) % 4, (v + 2) % 4};
            default: {
              // Flipping a coordinate mirrors the corner's frame.
              std::vector<int> ends;
              int n_flipped = 0;
              for (int d = 0; d < dimension(kind); ++d)
                {
                  ends.push_back(v ^ (1 << d));
                  n_flipped += (v >> d) & 1;
                }
              if (n_flipped % 2 == 1)
                std::swap(ends[0], ends[1]);
              return ends;
            }
        }
    }

    /** The scaled Jacobian of the regular simplex's corners. */
    double
    regular_value(const CellKind kind)
    {
      return kind == CellKind::triangle      ? std::sqrt(3.) / 2.
             : kind == CellKind::tetrahedron ? std::sqrt(2.) / 2.
                                             : 1.;
    }
  } // namespace

  double
  shape_quality(const Eigen::MatrixXd &points, const CellKind kind)
  {
    double smallest = 1e300;
    for (int v = 0; v < n_vertices(kind); ++v)
      {
        Eigen::MatrixXd edges(points.rows(), points.rows());
        double lengths      = 1.;
        Eigen::Index column = 0;
        for (const int end : neighbours(kind, v))
          {
            edges.col(column) = points.col(end) - points.col(v);
            lengths *= edges.col(column).norm();
            ++column;
          }
        smallest = std::min(smallest, edges.determinant() / lengths);
      }
    return smallest / regular_value(kind);
  }
} // namespace springfit
