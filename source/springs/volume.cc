#include <springfit/springs/cell_quadrature.h>
#include <springfit/springs/volume.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <stdexcept>

namespace springfit
{
  namespace
  {
    /** As a lazy product: that of large matrices takes longer to start. */
    template <int dim>
    Eigen::Matrix<double, dim, dim>
    jacobian(const Eigen::MatrixXd &points, const Eigen::MatrixXd &gradients)
    {
      return points.lazyProduct(gradients.transpose());
    }

    template <int dim>
    double
    integrate(const Eigen::MatrixXd &points, const CellKind kind)
    {
      double sum = 0.;
      for (const auto &[gradients, weight] : cell_quadrature(kind))
        sum += weight * jacobian<dim>(points, gradients).determinant();
      return sum;
    }

    /** The derivative of det J with respect to J's entries. */
    template <int dim>
    Eigen::Matrix<double, dim, dim>
    cofactors(const Eigen::Matrix<double, dim, dim> &J)
    {
      Eigen::Matrix<double, dim, dim> result;
      if constexpr (dim == 2)
        result << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
      else
        for (int d = 0; d < 3; ++d)
          result.col(d) = J.col((d + 1) % 3).cross(J.col((d + 2) % 3));
      return result;
    }

    /**
     * The second derivative of det (sum_v x_v g_v^T) with respect to x_v and
     * x_w: eps_ac (g_v x g_w) in 2-d, eps_acd [J (g_v x g_w)]_d in 3-d.
     */
    template <int dim>
    Eigen::Matrix<double, dim, dim>
    mixed_derivative(const Eigen::Matrix<double, dim, dim> &J,
                     const Eigen::Matrix<double, dim, 1> &g_v,
                     const Eigen::Matrix<double, dim, 1> &g_w)
    {
      Eigen::Matrix<double, dim, dim> result;
      if constexpr (dim == 2)
        {
          const double turn = g_v[0] * g_w[1] - g_v[1] * g_w[0];
          result << 0., turn, -turn, 0.;
        }
      else
        {
          const Eigen::Vector3d r = J * g_v.cross(g_w);
          result << 0., r[2], -r[1], -r[2], 0., r[0], r[1], -r[0], 0.;
        }
      return result;
    }

    template <int dim>
    Eigen::VectorXd
    gradient(const Eigen::MatrixXd &points, const CellKind kind)
    {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(dim, points.cols());
      for (const auto &[gradients, weight] : cell_quadrature(kind))
        {
          const auto J = jacobian<dim>(points, gradients);
          sum += weight * cofactors<dim>(J).lazyProduct(gradients);
        }
      return Eigen::Map<const Eigen::VectorXd>(sum.data(), sum.size());
    }

    template <int dim>
    Eigen::MatrixXd
    hessian(const Eigen::MatrixXd &points, const CellKind kind)
    {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(points.size(), points.size());
      for (const auto &[gradients, weight] : cell_quadrature(kind))
        {
          const auto J = jacobian<dim>(points, gradients);
          for (Eigen::Index v = 0; v < points.cols(); ++v)
            for (Eigen::Index w = 0; w < points.cols(); ++w)
              sum.block<dim, dim>(dim * v, dim * w) +=
                weight *
                mixed_derivative<dim>(J, gradients.col(v), gradients.col(w));
        }
      return sum;
    }
  } // namespace

  double
  volume(const Eigen::MatrixXd &points, const CellKind kind)
  {
    return dimension(kind) == 2 ? integrate<2>(points, kind)
                                : integrate<3>(points, kind);
  }


  Eigen::VectorXd
  volume_gradient(const Eigen::MatrixXd &points, const CellKind kind)
  {
    return dimension(kind) == 2 ? gradient<2>(points, kind)
                                : gradient<3>(points, kind);
  }


  Eigen::MatrixXd
  volume_hessian(const Eigen::MatrixXd &points, const CellKind kind)
  {
    return dimension(kind) == 2 ? hessian<2>(points, kind)
                                : hessian<3>(points, kind);
  }


  CellKind
  cell_kind(const int dim, const std::size_t n)
  {
    for (const auto &entry : cell_kind_words())
      if (dimension(entry.first) == dim &&
          static_cast<std::size_t>(n_vertices(entry.first)) == n)
        return entry.first;
    throw std::logic_error("no cell has this number of vertices");
  }
} // namespace springfit
