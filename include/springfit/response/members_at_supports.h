#ifndef springfit_response_members_at_supports_h
#define springfit_response_members_at_supports_h

#include <springfit/response/discretization.h>
#include <springfit/response/elastic_body.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace springfit
{
  /**
   * The springs or cells of a body that touch held nodes: all that it takes to
   * move the supports and to know their forces. Its functions are collective,
   * all matrices dim x n_nodes.
   */
  template <int dim>
  class MembersAtSupports
  {
  public:
    /** @p discretization must outlive the object. */
    MembersAtSupports(const Discretization<dim> &discretization,
                      const BodyOfMembers &body);

    /**
     * The tangent stiffness at @p displacement times displacements @p u of what
     * is held, N.
     */
    Eigen::MatrixXd
    tangent_product(const Eigen::MatrixXd &displacement,
                    const Eigen::MatrixXd &u) const;

    // The forces of the supports on the body under the forces @p external, N,
    // of a body in equilibrium; 0 where it is free.

    Eigen::MatrixXd
    reactions(const Eigen::MatrixXd &displacement,
              const Eigen::MatrixXd &external) const;

    /** By the tangent stiffness at rest. */
    Eigen::MatrixXd
    linear_reactions(const Eigen::MatrixXd &displacement,
                     const Eigen::MatrixXd &external) const;

  private:
    /** The sum over all ranks. */
    Eigen::MatrixXd
    sum(Eigen::MatrixXd of_rank) const;

    const Discretization<dim> &discretization_;
    const std::unique_ptr<const BodyOfMembers> members_;
  };

  /**
   * What is left of @p inner - @p external (dim x n_nodes) where a flag per
   * unknown says that it is held; 0 elsewhere.
   */
  Eigen::MatrixXd
  where_held(const std::vector<bool> &held,
             const Eigen::MatrixXd &inner,
             const Eigen::MatrixXd &external);
} // namespace springfit

#endif
