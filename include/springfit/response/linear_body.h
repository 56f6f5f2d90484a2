#ifndef springfit_response_linear_body_h
#define springfit_response_linear_body_h

#include <springfit/response/elastic_body.h>
#include <springfit/springs/tangent_operator.h>

#include <Eigen/SparseCore>

#include <memory>

namespace springfit
{
  /** A body with the stiffness that another one has at rest. */
  class LinearBody : public ElasticBody
  {
  public:
    /** @param dim, n_nodes of @p body */
    LinearBody(const ElasticBody &body, int dim, Eigen::Index n_nodes);

    double
    energy(const Eigen::MatrixXd &displacement) const override;

    void
    add_forces(const Eigen::MatrixXd &displacement,
               Eigen::MatrixXd &forces) const override;

    void
    add_tangent_product(const Eigen::MatrixXd &displacement,
                        const Eigen::MatrixXd &u,
                        Eigen::MatrixXd &product) const override;

    std::unique_ptr<TangentOperator>
    tangent_operator() const override;

    void
    add_tangent(const Eigen::MatrixXd &displacement,
                TangentMatrix &tangent) const override;

    /** The tangent, which is the same everywhere. */
    void
    add_convex_tangent(const Eigen::MatrixXd &displacement,
                       TangentMatrix &tangent) const override;

    void
    add_to_pattern(NodePattern &pattern) const override;

    bool
    has_constant_tangent() const override;

  private:
    const int dim_;
    Eigen::SparseMatrix<double> stiffness_; // row dim * v + d
  };
} // namespace springfit

#endif
