#ifndef springfit_springs_assembled_operator_h
#define springfit_springs_assembled_operator_h

#include <springfit/springs/tangent_matrix.h>
#include <springfit/springs/tangent_operator.h>

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace springfit
{
  /**
   * A Hessian as a matrix that is assembled at each state: worth it where its
   * entries are much fewer than those of the Hessians that it is a sum of.
   */
  class AssembledOperator : public TangentOperator
  {
  public:
    /**
     * @param add_to_pattern adds which nodes have entries in common
     * @param add_hessian adds the Hessian at a state
     */
    AssembledOperator(std::function<void(NodePattern &)> add_to_pattern,
                      std::function<void(const Eigen::MatrixXd &state,
                                         TangentMatrix &)> add_hessian);

    void
    linearise(const Eigen::MatrixXd &state) override;

    void
    add_product(const Eigen::MatrixXd &u,
                Eigen::MatrixXd &product) const override;

  private:
    const std::function<void(NodePattern &)> add_to_pattern_;
    const std::function<void(const Eigen::MatrixXd &, TangentMatrix &)>
      add_hessian_;
    std::optional<TangentMatrix> matrix_; // none before the first state
  };
} // namespace springfit

#endif
