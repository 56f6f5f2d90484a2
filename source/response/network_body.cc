#include <springfit/response/network_body.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace springfit
{
  namespace
  {
    class NetworkOperator : public TangentOperator
    {
    public:
      NetworkOperator(const Eigen::MatrixXd &nodes, const Families &families)
        : nodes_(nodes)
      {
        for (const Family &family : families)
          operators_.push_back(family.kind->tangent_operator(family.members));
      }

      void
      linearise(const Eigen::MatrixXd &state) override
      {
        const Eigen::MatrixXd x = nodes_ + state;
        for (const auto &of_family : operators_)
          of_family->linearise(x);
      }

      void
      add_product(const Eigen::MatrixXd &u,
                  Eigen::MatrixXd &product) const override
      {
        for (const auto &of_family : operators_)
          of_family->add_product(u, product);
      }

    private:
      const Eigen::MatrixXd &nodes_;
      std::vector<std::unique_ptr<TangentOperator>> operators_;
    };
  } // namespace


  NetworkBody::NetworkBody(const SpringNetwork &network)
    : NetworkBody(network.nodes, network.families)
  {}

  NetworkBody::NetworkBody(Eigen::MatrixXd nodes, Families families)
    : nodes_(std::move(nodes)), families_(std::move(families))
  {}

  double
  NetworkBody::energy(const Eigen::MatrixXd &displacement) const
  {
    return springfit::energy(families_, nodes_ + displacement);
  }

  void
  NetworkBody::add_forces(const Eigen::MatrixXd &displacement,
                          Eigen::MatrixXd &forces) const
  {
    springfit::add_forces(families_, nodes_ + displacement, forces);
  }

  void
  NetworkBody::add_tangent_product(const Eigen::MatrixXd &displacement,
                                   const Eigen::MatrixXd &u,
                                   Eigen::MatrixXd &product) const
  {
    springfit::add_tangent_product(families_,
                                   nodes_ + displacement,
                                   u,
                                   product);
  }

  std::unique_ptr<TangentOperator>
  NetworkBody::tangent_operator() const
  {
    return std::make_unique<NetworkOperator>(nodes_, families_);
  }

  void
  NetworkBody::add_tangent(const Eigen::MatrixXd &displacement,
                           TangentMatrix &tangent) const
  {
    springfit::add_tangent(families_, nodes_ + displacement, tangent);
  }

  void
  NetworkBody::add_convex_tangent(const Eigen::MatrixXd &displacement,
                                  TangentMatrix &tangent) const
  {
    const Eigen::MatrixXd x = nodes_ + displacement;
    for (const auto &family : families_)
      family.kind->add_convex_tangent(family.members, x, tangent);
  }

  void
  NetworkBody::add_to_pattern(NodePattern &pattern) const
  {
    springfit::add_to_pattern(families_, pattern);
  }

  template <typename Condition>
  std::unique_ptr<const BodyOfMembers>
  NetworkBody::part(const Condition &is_wanted) const
  {
    Families wanted;
    for (const auto &family : families_)
      {
        const unsigned int n_nodes = family.kind->n_nodes();
        std::vector<std::size_t> members;
        for (std::size_t m = 0; m < family.size(); ++m)
          if (is_wanted(family.nodes(m), n_nodes))
            members.push_back(m);
        wanted.push_back(selected(family, members));
      }
    return std::make_unique<NetworkBody>(nodes_, std::move(wanted));
  }

  std::unique_ptr<const BodyOfMembers>
  NetworkBody::share(const std::vector<bool> &nodes) const
  {
    return part([&](const unsigned int *of_member, unsigned int) {
      return nodes[*of_member];
    });
  }

  std::unique_ptr<const BodyOfMembers>
  NetworkBody::touching(const std::vector<bool> &nodes) const
  {
    return part([&](const unsigned int *of_member, const unsigned int n) {
      return std::any_of(of_member, of_member + n, [&](const unsigned int v) {
        return nodes[v];
      });
    });
  }
} // namespace springfit
