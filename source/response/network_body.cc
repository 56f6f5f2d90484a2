#include <springfit/response/network_body.h>
#include <springfit/springs/network_terms.h>

namespace springfit
{
  template <int dim>
  NetworkBody<dim>::NetworkBody(const SpringNetwork &network)
    : network_(network)
  {}

  template <int dim>
  unsigned int
  NetworkBody<dim>::n_terms() const
  {
    return springfit::n_terms(network_);
  }

  template <int dim>
  unsigned int
  NetworkBody<dim>::first_node(const unsigned int term) const
  {
    return springfit::first_node(network_, term);
  }

  template <int dim>
  std::optional<EnergyTerm>
  NetworkBody<dim>::evaluate(const unsigned int term,
                             const Eigen::MatrixXd &displacement) const
  {
    return evaluate_term<dim>(network_, term, displacement);
  }

  template class NetworkBody<2>;
  template class NetworkBody<3>;
} // namespace springfit
