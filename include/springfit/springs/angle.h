#ifndef springfit_springs_angle_h
#define springfit_springs_angle_h

#include <springfit/springs/length.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace springfit
{
  // The coordinate of an angular spring: the angle theta in (0, pi), in
  // radians and without a sign, at the middle one of three nodes a, m, c.
  // u = x_a - x_m and v = x_c - x_m throughout, in m.
  //
  // Where the angle is straight or folded the gradient has no direction and the
  // Hessian no bound: ask is_degenerate_angle first.
  //
  // In the formulas p = u / |u|, q = v / |v|, and the unit vectors
  // e = (cos theta p - q) / sin theta, f = (cos theta q - p) / sin theta:
  // they are normal to the arms and point to where theta grows.

  /** |u x v|, in m^2. */
  template <int dim>
  double
  size_of_cross_product(const Vector<dim> &u, const Vector<dim> &v)
  {
    if constexpr (dim == 2)
      return std::abs(u[0] * v[1] - u[1] * v[0]);
    else
      return u.cross(v).norm();
  }

  /** atan2(|u x v|, u . v): as accurate near 0 and pi as elsewhere. */
  template <int dim>
  double
  angle(const Vector<dim> &u, const Vector<dim> &v)
  {
    return std::atan2(size_of_cross_product<dim>(u, v), u.dot(v));
  }

  /**
   * Whether the angle is straight or folded, sin theta < 1e-6, or an arm has no
   * length (less than 1e-12 of the other's), so that it has no derivatives.
   */
  template <int dim>
  bool
  is_degenerate_angle(const Vector<dim> &u, const Vector<dim> &v)
  {
    const auto [shorter, longer] = std::minmax({u.norm(), v.norm()});
    return !(shorter > 1e-12 * longer) ||
           !(size_of_cross_product<dim>(u, v) >= 1e-6 * shorter * longer);
  }

  /** With respect to (x_a, x_m, x_c): e / |u| at a, f / |v| at c; rad/m. */
  template <int dim>
  Vector<3 * dim>
  angle_gradient(const Vector<dim> &u, const Vector<dim> &v)
  {
    const Vector<dim> p = u.normalized(), q = v.normalized();
    const double cosine   = p.dot(q);
    const Vector<dim> g_u = (cosine * p - q).normalized() / u.norm();
    const Vector<dim> g_v = (cosine * q - p).normalized() / v.norm();
    Vector<3 * dim> gradient;
    gradient << g_u, -(g_u + g_v), g_v;
    return gradient;
  }

  /**
   * The Hessian with respect to (x_a, x_m, x_c), in rad/m^2. With the normal n
   * of the arms' plane, the derivatives with respect to u and v are
   * [cot theta n n^T - p e^T - e p^T] / |u|^2 twice to u,
   * [cot theta n n^T - q f^T - f q^T] / |v|^2 twice to v and
   * -n n^T / (sin theta |u| |v|) across; in 2-d there is no n.
   */
  template <int dim>
  Tensor<3 * dim>
  angle_hessian(const Vector<dim> &u, const Vector<dim> &v)
  {
    const double l_u = u.norm(), l_v = v.norm();
    const Vector<dim> p = u / l_u, q = v / l_v;
    const double cosine = p.dot(q);
    const Vector<dim> e = (cosine * p - q).normalized();
    const Vector<dim> f = (cosine * q - p).normalized();

    Tensor<dim> H_uu = -(p * e.transpose() + e * p.transpose());
    Tensor<dim> H_vv = -(q * f.transpose() + f * q.transpose());
    Tensor<dim> H_uv = Tensor<dim>::Zero();
    if constexpr (dim == 3)
      {
        const Vector<3> cross    = p.cross(q);
        const double sine        = cross.norm();
        const Tensor<3> n_dyadic = cross * cross.transpose() / (sine * sine);
        H_uu += cosine / sine * n_dyadic;
        H_vv += cosine / sine * n_dyadic;
        H_uv -= n_dyadic / (sine * l_u * l_v);
      }
    H_uu /= l_u * l_u;
    H_vv /= l_v * l_v;

    // u and v are differences of nodes.
    const Tensor<dim> H_um = -(H_uu + H_uv), H_mv = -(H_vv + H_uv);
    Tensor<3 * dim> hessian;
    hessian << H_uu, H_um, H_uv,                          //
      H_um.transpose(), -(H_um + H_mv.transpose()), H_mv, //
      H_uv.transpose(), H_mv.transpose(), H_vv;
    return hessian;
  }
} // namespace springfit

#endif
