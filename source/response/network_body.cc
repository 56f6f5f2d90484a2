#include <springfit/response/network_body.h>
#include <springfit/springs/coupling.h>
#include <springfit/springs/generalised_spring.h>
#include <springfit/springs/length.h>
#include <springfit/springs/volume.h>

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

    template <int dim>
    std::optional<EnergyTerm>
    coupling_term(const SpringNetwork &network,
                  const Eigen::MatrixXd &displacement,
                  const LengthCoupling &coupling)
    {
      const auto [a, b, k]  = coupling;
      const Vector<dim> d_a = between<dim>(network, displacement, a);
      const Vector<dim> d_b = between<dim>(network, displacement, b);
      const double rest_a   = network.rest_length[a];
      const double rest_b   = network.rest_length[b];
      if (!(length<dim>(d_a) > 1e-12 * rest_a &&
            length<dim>(d_b) > 1e-12 * rest_b))
        return {};
      return EnergyTerm{
        {network.i[a], network.j[a], network.i[b], network.j[b]},
        coupling_energy<dim>(k, rest_a, rest_b, d_a, d_b),
        coupling_gradient<dim>(k, rest_a, rest_b, d_a, d_b),
        coupling_hessian<dim>(k, rest_a, rest_b, d_a, d_b)};
    }

    template <int dim>
    EnergyTerm
    volume_term(const SpringNetwork &network,
                const Eigen::MatrixXd &displacement,
                const VolumeSpring &spring)
    {
      Eigen::MatrixXd points(dim, spring.nodes.size());
      for (std::size_t v = 0; v < spring.nodes.size(); ++v)
        points.col(v) = network.nodes.col(spring.nodes[v]) +
                        displacement.col(spring.nodes[v]);
      const CellKind kind            = cell_kind(dim, spring.nodes.size());
      const double V                 = volume(points, kind);
      const Eigen::VectorXd gradient = volume_gradient(points, kind);
      const double k = spring.stiffness, rest = spring.rest_volume;
      return {
        spring.nodes,
        spring_energy(k, V, rest),
        -spring_force(k, V, rest, gradient),
        spring_tangent(k, V, rest, gradient, volume_hessian(points, kind))};
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
    return network_.stiffness.size() + network_.couplings.size() +
           network_.volumes.size();
  }

  template <int dim>
  unsigned int
  NetworkBody<dim>::first_node(const unsigned int term) const
  {
    const std::size_t n_springs   = network_.stiffness.size();
    const std::size_t n_couplings = network_.couplings.size();
    if (term < n_springs)
      return network_.i[term];
    if (term < n_springs + n_couplings)
      return network_.i[network_.couplings[term - n_springs].a];
    return network_.volumes[term - n_springs - n_couplings].nodes[0];
  }

  template <int dim>
  std::optional<EnergyTerm>
  NetworkBody<dim>::evaluate(const unsigned int term,
                             const Eigen::MatrixXd &displacement) const
  {
    const std::size_t n_springs   = network_.stiffness.size();
    const std::size_t n_couplings = network_.couplings.size();
    if (term < n_springs)
      return length_term<dim>(network_, displacement, term);
    if (term < n_springs + n_couplings)
      return coupling_term<dim>(network_,
                                displacement,
                                network_.couplings[term - n_springs]);
    return volume_term<dim>(network_,
                            displacement,
                            network_.volumes[term - n_springs - n_couplings]);
  }

  template class NetworkBody<2>;
  template class NetworkBody<3>;
} // namespace springfit
