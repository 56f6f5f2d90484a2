#ifndef springfit_springs_coupling_h
#define springfit_springs_coupling_h

#include <springfit/springs/elongation.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * A term between the elongations q of two springs (elongation.h), of the
   * energy stiffness q_a q_b, in J. A spring that others couple to may itself
   * have no stiffness.
   */
  struct LengthCoupling
  {
    /** The springs' positions in the list they belong to, a < b. */
    unsigned int a;
    unsigned int b;

    /** N/m */
    double stiffness;
  };

  // The energy as a function of the nodes' places (i_a, j_a, i_b, j_b).
  // Springs with a common node count it twice; what belongs to it is then
  // added.

  /** J */
  template <int dim>
  double
  coupling_energy(const double stiffness,
                  const Elongation<dim> &a,
                  const Elongation<dim> &b)
  {
    return stiffness * a.value() * b.value();
  }

  /**
   * The gradient in N, the opposite of the forces:
   * stiffness [q_b grad q_a, q_a grad q_b].
   */
  template <int dim>
  Vector<4 * dim>
  coupling_gradient(const double stiffness,
                    const Elongation<dim> &a,
                    const Elongation<dim> &b)
  {
    Vector<4 * dim> gradient;
    gradient << stiffness * b.value() * a.gradient(),
      stiffness * a.value() * b.gradient();
    return gradient;
  }

  /**
   * The Hessian in N/m; at rest only stiffness grad q_a grad q_b^T and its
   * transpose remain, off the diagonal.
   */
  template <int dim>
  Tensor<4 * dim>
  coupling_hessian(const double stiffness,
                   const Elongation<dim> &a,
                   const Elongation<dim> &b)
  {
    const Tensor<2 *dim> across =
      stiffness * a.gradient() * b.gradient().transpose();
    Tensor<4 * dim> hessian;
    hessian << stiffness * b.value() * a.hessian(), across, //
      across.transpose(), stiffness * a.value() * b.hessian();
    return hessian;
  }
} // namespace springfit

#endif
