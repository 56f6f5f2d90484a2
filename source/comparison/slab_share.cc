#include <springfit/comparison/slab_share.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace springfit
{
  namespace
  {
    /** Of n sorted heights, n > 0. */
    double
    share_below(const double *heights, const int n, const double level)
    {
      const double lowest = heights[0], highest = heights[n - 1];
      if (level >= highest)
        return 1.;
      if (level <= lowest)
        return 0.;
      return ((level - lowest) * share_below(heights, n - 1, level) +
              (highest - level) * share_below(heights + 1, n - 1, level)) /
             (highest - lowest);
    }

    /** The cell as simplices, each a list of its vertices (Kuhn 1960). */
    std::vector<std::vector<int>>
    simplices_of(const CellKind kind)
    {
      if (is_simplex(kind))
        {
          std::vector<int> all(n_vertices(kind));
          std::iota(all.begin(), all.end(), 0);
          return {all};
        }
      // Each order of the coordinates is a path of edges along the main
      // diagonal.
      std::vector<std::vector<int>> simplices;
      std::vector<int> order(dimension(kind));
      std::iota(order.begin(), order.end(), 0);
      do
        {
          std::vector<int> path = {0};
          for (const int d : order)
            path.push_back(path.back() | (1 << d));
          simplices.push_back(path);
      } while (std::next_permutation(order.begin(), order.end()));
      return simplices;
    }
  } // namespace

  double
  simplex_share_below(std::vector<double> heights, const double level)
  {
    std::sort(heights.begin(), heights.end());
    return share_below(heights.data(), heights.size(), level);
  }

  double
  slab_share(const Eigen::MatrixXd &points,
             const CellKind kind,
             const Eigen::VectorXd &axis,
             const double lowest,
             const double highest)
  {
    const Eigen::Index dim = dimension(kind);
    const auto heights     = (axis.transpose() * points).eval();
    double inside = 0., total = 0.;
    for (const auto &simplex : simplices_of(kind))
      {
        Eigen::MatrixXd edges(points.rows(), dim);
        std::vector<double> h;
        for (Eigen::Index v = 0; v <= dim; ++v)
          {
            h.push_back(heights(simplex[v]));
            if (v > 0)
              edges.col(v - 1) =
                points.col(simplex[v]) - points.col(simplex[0]);
          }
        const double volume =
          edges.rows() == dim
            ? std::abs(edges.determinant())
            : std::sqrt((edges.transpose() * edges).determinant());
        total += volume;
        inside += volume * (simplex_share_below(h, highest) -
                            simplex_share_below(h, lowest));
      }
    return inside / total;
  }
} // namespace springfit
