#include <springfit/calibration/congruence.h>
#include <springfit/springs/cell_topology.h>

#include <cmath>
#include <numeric>

namespace springfit
{
  namespace
  {
    /**
     * Steps of 1e-9. The offset moves their limits away from the numbers that
     * the distances of regular cells are: fractions and roots of fractions.
     */
    std::int64_t
    to_integer(const double relative_length)
    {
      constexpr double resolution = 1e-9;
      constexpr double offset     = 0.2718281828459045;
      return std::llround(relative_length / resolution + offset);
    }

    Eigen::MatrixXd
    distances_of(const Eigen::MatrixXd &points)
    {
      const Eigen::Index n = points.cols();
      Eigen::MatrixXd distances(n, n);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
          distances(i, j) = (points.col(j) - points.col(i)).norm();
      return distances;
    }

    using IntegerMatrix =
      Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;

    /** Less than, equal to or greater than zero: whether p comes before q. */
    std::int64_t
    compare(const IntegerMatrix &distances,
            const std::vector<NodePair> &pairs,
            const std::vector<unsigned int> &p,
            const std::vector<unsigned int> &q)
    {
      for (const auto &[i, j] : pairs)
        {
          const std::int64_t difference =
            distances(p[i], p[j]) - distances(q[i], q[j]);
          if (difference != 0)
            return difference;
        }
      return 0;
    }
  } // namespace


  bool
  operator==(const ShapeKey &a, const ShapeKey &b)
  {
    return a.kind == b.kind && a.lengths == b.lengths;
  }


  bool
  operator!=(const ShapeKey &a, const ShapeKey &b)
  {
    return !(a == b);
  }


  CanonicalShape
  canonical_shape(const Eigen::MatrixXd &points, const CellKind kind)
  {
    const Eigen::MatrixXd distances = distances_of(points);
    const double size               = distances.maxCoeff();
    const IntegerMatrix integers    = (distances / size).unaryExpr(&to_integer);
    const auto &pairs               = node_pairs(kind);

    const std::vector<unsigned int> *smallest = nullptr;
    for (const auto &symmetry : symmetries(kind))
      if (smallest == nullptr ||
          compare(integers, pairs, symmetry, *smallest) < 0)
        smallest = &symmetry;

    CanonicalShape shape{{kind, {}}, *smallest, size};
    for (const auto &[i, j] : pairs)
      shape.key.lengths.push_back(integers((*smallest)[i], (*smallest)[j]));
    return shape;
  }


  CanonicalShape
  oriented_shape(const Eigen::MatrixXd &points, const CellKind kind)
  {
    CanonicalShape shape{{kind, {}},
                         std::vector<unsigned int>(points.cols()),
                         distances_of(points).maxCoeff()};
    std::iota(shape.permutation.begin(), shape.permutation.end(), 0);
    const IntegerMatrix integers =
      ((points.colwise() - points.col(0)) / shape.size).unaryExpr(&to_integer);
    shape.key.lengths.assign(integers.data(),
                             integers.data() + integers.size());
    return shape;
  }
} // namespace springfit


std::size_t
std::hash<springfit::ShapeKey>::operator()(
  const springfit::ShapeKey &key) const noexcept
{
  std::size_t seed = static_cast<std::size_t>(key.kind);
  for (const auto length : key.lengths)
    seed ^= std::hash<std::int64_t>()(length) + 0x9e3779b97f4a7c15u +
            (seed << 6) + (seed >> 2);
  return seed;
}
