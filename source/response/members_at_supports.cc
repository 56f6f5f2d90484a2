#include <springfit/response/members_at_supports.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

namespace springfit
{
  namespace
  {
    /** Those of this rank. */
    template <int dim>
    std::unique_ptr<const BodyOfMembers>
    members_at_supports(const Discretization<dim> &discretization,
                        const BodyOfMembers &body)
    {
      std::vector<bool> nodes(discretization.n_nodes(), false);
      for (std::size_t i = 0; i < discretization.held().size(); ++i)
        if (discretization.held()[i])
          nodes[i / dim] = true;
      return body.touching(nodes)->share(discretization.owned_nodes());
    }
  } // namespace

  template <int dim>
  MembersAtSupports<dim>::MembersAtSupports(
    const Discretization<dim> &discretization,
    const BodyOfMembers &body)
    : discretization_(discretization)
    , members_(members_at_supports(discretization, body))
  {}

  template <int dim>
  Eigen::MatrixXd
  MembersAtSupports<dim>::tangent_product(const Eigen::MatrixXd &displacement,
                                          const Eigen::MatrixXd &u) const
  {
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(u.rows(), u.cols());
    members_->add_tangent_product(displacement, u, product);
    return sum(product);
  }

  template <int dim>
  Eigen::MatrixXd
  MembersAtSupports<dim>::reactions(const Eigen::MatrixXd &displacement,
                                    const Eigen::MatrixXd &external) const
  {
    Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(displacement.rows(), displacement.cols());
    members_->add_forces(displacement, forces);
    return where_held(discretization_.held(), -sum(forces), external);
  }

  template <int dim>
  Eigen::MatrixXd
  MembersAtSupports<dim>::linear_reactions(
    const Eigen::MatrixXd &displacement,
    const Eigen::MatrixXd &external) const
  {
    const Eigen::MatrixXd rest =
      Eigen::MatrixXd::Zero(displacement.rows(), displacement.cols());
    return where_held(discretization_.held(),
                      tangent_product(rest, displacement),
                      external);
  }

  template <int dim>
  Eigen::MatrixXd
  MembersAtSupports<dim>::sum(Eigen::MatrixXd of_rank) const
  {
    const dealii::ArrayView<double> entries(of_rank.data(), of_rank.size());
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(entries),
                                discretization_.communicator(),
                                entries);
    return of_rank;
  }

  Eigen::MatrixXd
  where_held(const std::vector<bool> &held,
             const Eigen::MatrixXd &inner,
             const Eigen::MatrixXd &external)
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(inner.rows(), inner.cols());
    for (std::size_t i = 0; i < held.size(); ++i)
      if (held[i])
        result.reshaped()[i] = inner.reshaped()[i] - external.reshaped()[i];
    return result;
  }

  template class MembersAtSupports<2>;
  template class MembersAtSupports<3>;
} // namespace springfit
