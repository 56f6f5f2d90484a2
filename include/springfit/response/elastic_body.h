#ifndef springfit_response_elastic_body_h
#define springfit_response_elastic_body_h

#include <springfit/springs/tangent_matrix.h>
#include <springfit/springs/tangent_operator.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace springfit
{
  /**
   * What all models are to statics and in motion: an elastic energy of the
   * displacements of nodes (dim x n_nodes, m), and its derivatives.
   */
  class ElasticBody
  {
  public:
    virtual ~ElasticBody() = default;

    /** J; not finite where the body has no energy or no derivatives. */
    virtual double
    energy(const Eigen::MatrixXd &displacement) const = 0;

    // At displacements of finite energy only.

    /** Add the forces on the nodes, -grad U, in N; dim x n_nodes. */
    virtual void
    add_forces(const Eigen::MatrixXd &displacement,
               Eigen::MatrixXd &forces) const = 0;

    /**
     * Add the Hessian of the energy times a motion @p u (dim x n_nodes, m) to
     * @p product (as it, N).
     */
    virtual void
    add_tangent_product(const Eigen::MatrixXd &displacement,
                        const Eigen::MatrixXd &u,
                        Eigen::MatrixXd &product) const = 0;

    /**
     * The Hessian as an operator whose states are displacements, for many
     * products at each. The body must outlive it.
     */
    virtual std::unique_ptr<TangentOperator>
    tangent_operator() const = 0;

    /** Add the Hessian of the energy, N/m. */
    virtual void
    add_tangent(const Eigen::MatrixXd &displacement,
                TangentMatrix &tangent) const = 0;

    /**
     * The same as add_tangent() with the negative eigenvalues of each spring's
     * or cell's Hessian left out: positive semidefinite, so that its Newton
     * step leads downhill everywhere (Teran, Sifakis, Irving and Fedkiw 2005).
     */
    virtual void
    add_convex_tangent(const Eigen::MatrixXd &displacement,
                       TangentMatrix &tangent) const = 0;

    /** The nodes that have entries in the tangent with each other. */
    virtual void
    add_to_pattern(NodePattern &pattern) const = 0;

    /** Whether the tangent is the same at all displacements. */
    virtual bool
    has_constant_tangent() const
    {
      return false;
    }
  };


  /** A body that is a sum of springs or cells. */
  class BodyOfMembers : public ElasticBody
  {
  public:
    /**
     * The part of the body whose springs or cells have their first node among
     * those flagged: the parts of all ranks together are the body.
     */
    virtual std::unique_ptr<const BodyOfMembers>
    share(const std::vector<bool> &nodes) const = 0;

    /** The springs or cells that have any node among those flagged. */
    virtual std::unique_ptr<const BodyOfMembers>
    touching(const std::vector<bool> &nodes) const = 0;
  };
} // namespace springfit

#endif
