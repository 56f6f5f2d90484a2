#ifndef springfit_response_network_body_h
#define springfit_response_network_body_h

#include <springfit/response/elastic_body.h>
#include <springfit/springs/network.h>
#include <springfit/springs/tangent_operator.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace springfit
{
  /** Families of springs as a body. */
  class NetworkBody : public BodyOfMembers
  {
  public:
    explicit NetworkBody(const SpringNetwork &network);

    /** @param nodes places at rest, dim x n_nodes, m */
    NetworkBody(Eigen::MatrixXd nodes, Families families);

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

    void
    add_convex_tangent(const Eigen::MatrixXd &displacement,
                       TangentMatrix &tangent) const override;

    void
    add_to_pattern(NodePattern &pattern) const override;

    std::unique_ptr<const BodyOfMembers>
    share(const std::vector<bool> &nodes) const override;

    std::unique_ptr<const BodyOfMembers>
    touching(const std::vector<bool> &nodes) const override;

  private:
    /** Of the members whose nodes (from a place on, so many) are wanted. */
    template <typename Condition>
    std::unique_ptr<const BodyOfMembers>
    part(const Condition &is_wanted) const;

    const Eigen::MatrixXd nodes_;
    const Families families_;
  };
} // namespace springfit

#endif
