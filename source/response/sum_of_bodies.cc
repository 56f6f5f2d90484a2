#include <springfit/response/sum_of_bodies.h>

#include <utility>

namespace springfit
{
  namespace
  {
    using Parts = std::vector<std::unique_ptr<const BodyOfMembers>>;

    class SumOperator : public TangentOperator
    {
    public:
      explicit SumOperator(const Parts &parts)
      {
        for (const auto &part : parts)
          operators_.push_back(part->tangent_operator());
      }

      void
      linearise(const Eigen::MatrixXd &state) override
      {
        for (const auto &of_part : operators_)
          of_part->linearise(state);
      }

      void
      add_product(const Eigen::MatrixXd &u,
                  Eigen::MatrixXd &product) const override
      {
        for (const auto &of_part : operators_)
          of_part->add_product(u, product);
      }

    private:
      std::vector<std::unique_ptr<TangentOperator>> operators_;
    };
  } // namespace

  SumOfBodies::SumOfBodies(Parts parts) : parts_(std::move(parts))
  {}

  double
  SumOfBodies::energy(const Eigen::MatrixXd &displacement) const
  {
    double sum = 0.;
    for (const auto &part : parts_)
      sum += part->energy(displacement);
    return sum;
  }

  void
  SumOfBodies::add_forces(const Eigen::MatrixXd &displacement,
                          Eigen::MatrixXd &forces) const
  {
    for (const auto &part : parts_)
      part->add_forces(displacement, forces);
  }

  void
  SumOfBodies::add_tangent_product(const Eigen::MatrixXd &displacement,
                                   const Eigen::MatrixXd &u,
                                   Eigen::MatrixXd &product) const
  {
    for (const auto &part : parts_)
      part->add_tangent_product(displacement, u, product);
  }

  std::unique_ptr<TangentOperator>
  SumOfBodies::tangent_operator() const
  {
    return std::make_unique<SumOperator>(parts_);
  }

  void
  SumOfBodies::add_tangent(const Eigen::MatrixXd &displacement,
                           TangentMatrix &tangent) const
  {
    for (const auto &part : parts_)
      part->add_tangent(displacement, tangent);
  }

  void
  SumOfBodies::add_convex_tangent(const Eigen::MatrixXd &displacement,
                                  TangentMatrix &tangent) const
  {
    for (const auto &part : parts_)
      part->add_convex_tangent(displacement, tangent);
  }

  void
  SumOfBodies::add_to_pattern(NodePattern &pattern) const
  {
    for (const auto &part : parts_)
      part->add_to_pattern(pattern);
  }

  std::unique_ptr<const BodyOfMembers>
  SumOfBodies::share(const std::vector<bool> &nodes) const
  {
    Parts shares;
    for (const auto &part : parts_)
      shares.push_back(part->share(nodes));
    return std::make_unique<SumOfBodies>(std::move(shares));
  }

  std::unique_ptr<const BodyOfMembers>
  SumOfBodies::touching(const std::vector<bool> &nodes) const
  {
    Parts touching;
    for (const auto &part : parts_)
      touching.push_back(part->touching(nodes));
    return std::make_unique<SumOfBodies>(std::move(touching));
  }
} // namespace springfit
