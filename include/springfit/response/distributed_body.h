#ifndef springfit_response_distributed_body_h
#define springfit_response_distributed_body_h

#include <springfit/response/discretization.h>
#include <springfit/response/elastic_body.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>

#include <memory>

namespace springfit
{
  /**
   * A body on the unknowns of a discretization: every rank computes its share,
   * and all of them together are the body. All functions are collective.
   * Displacements are dim x n_nodes in m.
   */
  template <int dim>
  class DistributedBody
  {
  public:
    using Vector = typename Discretization<dim>::Vector;
    using Matrix = typename Discretization<dim>::Matrix;

    /** @p discretization must outlive the object. */
    DistributedBody(const Discretization<dim> &discretization,
                    const BodyOfMembers &body);

    /** J; not finite where the body has none or no derivatives. */
    double
    energy(const Eigen::MatrixXd &displacement) const;

    /** The forces of the body in N; zero where it is held. */
    Vector
    forces(const Eigen::MatrixXd &displacement) const;

    /** The tangent stiffness; rows of what is held become diagonal. */
    void
    tangent(const Eigen::MatrixXd &displacement, Matrix &tangent);

    /** See BodyOfMembers::add_convex_tangent. */
    void
    convex_tangent(const Eigen::MatrixXd &displacement, Matrix &tangent);

    /**
     * The rounding errors in the norm of the forces, estimated, in N: what
     * errors of the nodes' places in the last digit change, with the tangent
     * stiffness there.
     */
    double
    rounding(const Eigen::MatrixXd &displacement, const Matrix &tangent) const;

  private:
    /** The share's matrix on the unknowns. */
    void
    distribute(Matrix &matrix) const;

    const Discretization<dim> &discretization_;
    const std::unique_ptr<const BodyOfMembers> share_;
    TangentMatrix of_share_;
  };
} // namespace springfit

#endif
