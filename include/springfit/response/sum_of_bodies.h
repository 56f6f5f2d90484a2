#ifndef springfit_response_sum_of_bodies_h
#define springfit_response_sum_of_bodies_h

#include <springfit/response/elastic_body.h>

#include <memory>
#include <vector>

namespace springfit
{
  /** Bodies that share their nodes, as one: energies and forces add up. */
  class SumOfBodies : public BodyOfMembers
  {
  public:
    explicit SumOfBodies(
      std::vector<std::unique_ptr<const BodyOfMembers>> parts);

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
    const std::vector<std::unique_ptr<const BodyOfMembers>> parts_;
  };
} // namespace springfit

#endif
