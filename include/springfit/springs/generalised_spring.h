#ifndef springfit_springs_generalised_spring_h
#define springfit_springs_generalised_spring_h

#include <Eigen/Core>

namespace springfit
{
  // A generalised spring is a scalar coordinate q(x), a rest value q0 and a
  // stiffness k. What follows from them is the same for lengths, angles,
  // areas and volumes.

  /** k (q - q0)^2 / 2, in J. */
  inline double
  spring_energy(const double k, const double q, const double q0)
  {
    return 0.5 * k * (q - q0) * (q - q0);
  }

  /**
   * The forces on the nodes, -k (q - q0) grad q: one per coordinate that
   * q depends on, in the order of @p gradient.
   */
  template <typename Vector>
  typename Vector::PlainObject
  spring_force(const double k,
               const double q,
               const double q0,
               const Eigen::MatrixBase<Vector> &gradient)
  {
    return -k * (q - q0) * gradient;
  }

  /**
   * The Hessian of the energy, k [grad q grad q^T + (q - q0) hess q]; at rest
   * the first term alone.
   */
  template <typename Vector, typename Matrix>
  typename Matrix::PlainObject
  spring_tangent(const double k,
                 const double q,
                 const double q0,
                 const Eigen::MatrixBase<Vector> &gradient,
                 const Eigen::MatrixBase<Matrix> &hessian)
  {
    return k * (gradient * gradient.transpose() + (q - q0) * hessian);
  }
} // namespace springfit

#endif
