#ifndef springfit_springs_tangent_operator_h
#define springfit_springs_tangent_operator_h

#include <Eigen/Core>

namespace springfit
{
  /**
   * The Hessian of an elastic energy at a state, prepared for many products:
   * what depends on the state alone is computed once. Motions and forces are
   * dim x n_nodes, in m and N.
   */
  class TangentOperator
  {
  public:
    virtual ~TangentOperator() = default;

    /**
     * The Hessian is that at @p state from now on: places of nodes or their
     * displacements, as the maker of the operator says.
     */
    virtual void
    linearise(const Eigen::MatrixXd &state) = 0;

    /** Add the Hessian times @p u to @p product. */
    virtual void
    add_product(const Eigen::MatrixXd &u, Eigen::MatrixXd &product) const = 0;
  };
} // namespace springfit

#endif
