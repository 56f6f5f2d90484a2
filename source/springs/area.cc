#include <springfit/springs/area.h>
#include <springfit/springs/cell_quadrature.h>

#include <Eigen/Geometry>

namespace springfit
{
  // At a quadrature point the tangents g_1 = sum_v x_v a_v, g_2 = sum_v x_v b_v
  // span the normal N = g_1 x g_2, and the area is the weighted sum of |N|.
  // Moving x_v by h changes N by h x s_v with s_v = a_v g_2 - b_v g_1.

  namespace
  {
    using Tangents = Eigen::Matrix<double, 3, 2>;

    Eigen::Vector3d
    normal(const Tangents &g)
    {
      return g.col(0).cross(g.col(1));
    }

    /** The s_v, 3 x n_vertices. */
    Eigen::Matrix3Xd
    levers(const Tangents &g, const Eigen::MatrixXd &shape_gradients)
    {
      return g.col(1) * shape_gradients.row(0) -
             g.col(0) * shape_gradients.row(1);
    }

    /** The matrix of s x. */
    Eigen::Matrix3d
    cross_matrix(const Eigen::Vector3d &s)
    {
      Eigen::Matrix3d matrix;
      matrix << 0., -s[2], s[1], s[2], 0., -s[0], -s[1], s[0], 0.;
      return matrix;
    }
  } // namespace

  double
  area(const Eigen::MatrixXd &points, const CellKind kind)
  {
    double sum = 0.;
    for (const auto &[gradients, weight] : cell_quadrature(kind))
      sum += weight * normal(points * gradients.transpose()).norm();
    return sum;
  }


  Eigen::VectorXd
  area_gradient(const Eigen::MatrixXd &points, const CellKind kind)
  {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(points.size());
    for (const auto &[gradients, weight] : cell_quadrature(kind))
      {
        const Tangents g         = points * gradients.transpose();
        const Eigen::Vector3d n  = normal(g).normalized();
        const Eigen::Matrix3Xd s = levers(g, gradients);
        for (Eigen::Index v = 0; v < points.cols(); ++v)
          sum.segment<3>(3 * v) += weight * s.col(v).cross(n);
      }
    return sum;
  }


  Eigen::MatrixXd
  area_hessian(const Eigen::MatrixXd &points, const CellKind kind)
  {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(points.size(), points.size());
    for (const auto &[gradients, weight] : cell_quadrature(kind))
      {
        const Tangents g         = points * gradients.transpose();
        const Eigen::Matrix3Xd s = levers(g, gradients);
        const double size        = normal(g).norm();
        const Eigen::Vector3d n  = normal(g) / size;
        // The change of N along N changes its size at once, that across N in
        // the second order; and N is bilinear in x_v and x_w.
        const Eigen::Matrix3d across =
          (Eigen::Matrix3d::Identity() - n * n.transpose()) / size;
        const Eigen::Matrix3d turn = cross_matrix(n);
        for (Eigen::Index v = 0; v < points.cols(); ++v)
          for (Eigen::Index w = 0; w < points.cols(); ++w)
            sum.block<3, 3>(3 * v, 3 * w) +=
              weight * (cross_matrix(s.col(v)).transpose() * across *
                          cross_matrix(s.col(w)) -
                        (gradients(0, v) * gradients(1, w) -
                         gradients(0, w) * gradients(1, v)) *
                          turn);
      }
    return sum;
  }
} // namespace springfit
