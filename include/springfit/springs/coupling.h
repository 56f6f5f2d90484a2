#ifndef springfit_springs_coupling_h
#define springfit_springs_coupling_h

#include <springfit/springs/length.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * A term between the lengths of two springs, of the energy
   * stiffness (l_a - L_a) (l_b - L_b) with the rest lengths L, in J. A spring
   * that others couple to may itself have no stiffness.
   */
  struct LengthCoupling
  {
    /** The springs' positions in the list they belong to, a < b. */
    unsigned int a;
    unsigned int b;

    /** N/m */
    double stiffness;
  };

  // The energy as a function of the nodes' places (i_a, j_a, i_b, j_b), with
  // d = x_j - x_i of each spring. Springs with a common node count it twice;
  // what belongs to it is then added.

  /** J */
  template <int dim>
  double
  coupling_energy(const double stiffness,
                  const double rest_length_a,
                  const double rest_length_b,
                  const Vector<dim> &d_a,
                  const Vector<dim> &d_b)
  {
    return stiffness * (d_a.norm() - rest_length_a) *
           (d_b.norm() - rest_length_b);
  }

  /**
   * The gradient in N, the opposite of the forces:
   * stiffness [(l_b - L_b) grad l_a, (l_a - L_a) grad l_b].
   */
  template <int dim>
  Vector<4 * dim>
  coupling_gradient(const double stiffness,
                    const double rest_length_a,
                    const double rest_length_b,
                    const Vector<dim> &d_a,
                    const Vector<dim> &d_b)
  {
    Vector<4 * dim> gradient;
    gradient << stiffness * (d_b.norm() - rest_length_b) *
                  length_gradient<dim>(d_a),
      stiffness * (d_a.norm() - rest_length_a) * length_gradient<dim>(d_b);
    return gradient;
  }

  /**
   * The Hessian in N/m; at rest only stiffness grad l_a grad l_b^T and its
   * transpose remain, off the diagonal.
   */
  template <int dim>
  Tensor<4 * dim>
  coupling_hessian(const double stiffness,
                   const double rest_length_a,
                   const double rest_length_b,
                   const Vector<dim> &d_a,
                   const Vector<dim> &d_b)
  {
    const Tensor<2 *dim> across = stiffness * length_gradient<dim>(d_a) *
                                  length_gradient<dim>(d_b).transpose();
    Tensor<4 * dim> hessian;
    hessian << stiffness * (d_b.norm() - rest_length_b) *
                 length_hessian<dim>(d_a),
      across, across.transpose(),
      stiffness * (d_a.norm() - rest_length_a) * length_hessian<dim>(d_b);
    return hessian;
  }
} // namespace springfit

#endif
