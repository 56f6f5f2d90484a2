#include <springfit/comparison/bending_ratio.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace springfit
{
  namespace
  {
    /** The mean edges of a cell along its own directions, columns. */
    Eigen::MatrixXd
    mean_edges(const Eigen::MatrixXd &points)
    {
      const Eigen::Index dim = points.rows();
      Eigen::MatrixXd edges  = Eigen::MatrixXd::Zero(dim, dim);
      for (Eigen::Index v = 0; v < points.cols(); ++v)
        for (Eigen::Index d = 0; d < dim; ++d)
          edges.col(d) +=
            (v >> d & 1 ? 2. : -2.) / points.cols() * points.col(v);
      return edges;
    }
  } // namespace


  double
  bending_ratio(const Eigen::MatrixXd &points,
                const CellKind kind,
                const Eigen::MatrixXd &stiffness,
                const double modulus)
  {
    assert(!is_simplex(kind));
    (void)kind;
    const Eigen::Index dim      = points.rows();
    const Eigen::MatrixXd edges = mean_edges(points);
    const Eigen::MatrixXd axes =
      Eigen::HouseholderQR<Eigen::MatrixXd>(edges).householderQ();
    const Eigen::MatrixXd x =
      axes.transpose() * (points.colwise() - points.rowwise().mean());
    const double volume = std::abs(edges.determinant());

    double largest = 0.;
    for (Eigen::Index a = 0; a < dim; ++a)
      for (Eigen::Index b = 0; b < dim; ++b)
        {
          if (a == b)
            continue;
          Eigen::MatrixXd u              = 0. * x;
          u.row(a)                       = -x.row(a).cwiseProduct(x.row(b));
          u.row(b)                       = 0.5 * x.row(a).cwiseAbs2();
          const Eigen::VectorXd in_space = (axes * u).reshaped();
          // The mean of x_b^2 over a parallelepiped is a third of that over its
          // vertices.
          const double beam =
            modulus * volume * x.row(b).squaredNorm() / (3. * x.cols());
          largest =
            std::max(largest, in_space.dot(stiffness * in_space) / beam);
        }
    return largest;
  }
} // namespace springfit
