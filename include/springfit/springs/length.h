#ifndef springfit_springs_length_h
#define springfit_springs_length_h

#include <Eigen/Core>

namespace springfit
{
  // The coordinate of an ordinary spring: the distance of two nodes.
  // d = x_j - x_i throughout, n = d / |d|; m in, m out.

  template <int dim>
  using Vector = Eigen::Matrix<double, dim, 1>;

  template <int dim>
  using Tensor = Eigen::Matrix<double, dim, dim>;

  template <int dim>
  double
  length(const Vector<dim> &d)
  {
    return d.norm();
  }

  /** The gradient with respect to (x_i, x_j): -n at i, n at j. */
  template <int dim>
  Vector<2 * dim>
  length_gradient(const Vector<dim> &d)
  {
    const Vector<dim> n = d.normalized();
    Vector<2 * dim> gradient;
    gradient << -n, n;
    return gradient;
  }

  /**
   * The Hessian with respect to (x_i, x_j): (I - n n^T) / |d| in the blocks
   * ii and jj, its negative in ij and ji.
   */
  template <int dim>
  Tensor<2 * dim>
  length_hessian(const Vector<dim> &d)
  {
    const Vector<dim> n = d.normalized();
    const Tensor<dim> across =
      (Tensor<dim>::Identity() - n * n.transpose()) / d.norm();
    Tensor<2 * dim> hessian;
    hessian << across, -across, -across, across;
    return hessian;
  }

  /** The force on node i, k (|d| - L0) n, in N; the one on j is opposite. */
  template <int dim>
  Vector<dim>
  length_force(const double k, const double rest_length, const Vector<dim> &d)
  {
    return k * (1. - rest_length / d.norm()) * d;
  }

  /**
   * The tangent's block of node i with itself (and of j with itself; ij and
   * ji have the opposite sign), in N/m:
   * k [n n^T + (1 - L0 / |d|) (I - n n^T)].
   */
  template <int dim>
  Tensor<dim>
  length_tangent_block(const double k,
                       const double rest_length,
                       const Vector<dim> &d)
  {
    const Vector<dim> n     = d.normalized();
    const Tensor<dim> along = n * n.transpose();
    return k * (along + (1. - rest_length / d.norm()) *
                          (Tensor<dim>::Identity() - along));
  }
} // namespace springfit

#endif
