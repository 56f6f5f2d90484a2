#include <springfit/response/network_body.h>
#include <springfit/springs/generalised_spring.h>
#include <springfit/springs/length.h>

namespace springfit
{
  namespace
  {
    template <int dim>
    Vector<dim>
    between(const SpringNetwork &network,
            const Eigen::MatrixXd &displacement,
            const unsigned int spring)
    {
      const unsigned int i = network.i[spring], j = network.j[spring];
      return (network.nodes.col(j) + displacement.col(j)) -
             (network.nodes.col(i) + displacement.col(i));
    }

    template <int dim>
    std::optional<EnergyTerm>
    length_term(const SpringNetwork &network,
                const Eigen::MatrixXd &displacement,
                const unsigned int s)
    {
      const Vector<dim> d = between<dim>(network, displacement, s);
      const double k = network.stiffness[s], rest = network.rest_length[s];
      const double l = length<dim>(d);
      if (!(l > 1e-12 * rest))
        return {}; // the direction of the force is lost
      const Vector<2 *dim> gradient = length_gradient<dim>(d);
      return EnergyTerm{
        {network.i[s], network.j[s]},
        spring_energy(k, l, rest),
        -spring_force(k, l, rest, gradient),
        spring_tangent(k, l, rest, gradient, length_hessian<dim>(d))};
    }
  } // namespace

  template <int dim>
  NetworkBody<dim>::NetworkBody(const SpringNetwork &network)
    : network_(network)
  {}

  template <int dim>
  unsigned int
  NetworkBody<dim>::n_terms() const
  {
    return network_.stiffness.size();
  }

  template <int dim>
  unsigned int
  NetworkBody<dim>::first_node(const unsigned int term) const
  {
    return network_.i[term];
  }

  template <int dim>
  std::optional<EnergyTerm>
  NetworkBody<dim>::evaluate(const unsigned int term,
                             const Eigen::MatrixXd &displacement) const
  {
    return length_term<dim>(network_, displacement, term);
  }

  template class NetworkBody<2>;
  template class NetworkBody<3>;
} // namespace springfit
