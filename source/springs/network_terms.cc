#include <springfit/springs/angle.h>
#include <springfit/springs/coupling.h>
#include <springfit/springs/elongation.h>
#include <springfit/springs/generalised_spring.h>
#include <springfit/springs/network_terms.h>
#include <springfit/springs/volume.h>

namespace springfit
{
  namespace
  {
    /** An ordinary spring by its position in the network's list. */
    struct LengthSpring
    {
      unsigned int position;
    };

    /** Calls @p f with the part of the network that a term is. */
    template <typename F>
    auto
    with_part(const SpringNetwork &network, const unsigned int term, const F &f)
    {
      std::size_t t = term;
      if (t < network.stiffness.size())
        return f(LengthSpring{term});
      t -= network.stiffness.size();
      if (t < network.couplings.size())
        return f(network.couplings[t]);
      t -= network.couplings.size();
      if (t < network.angles.size())
        return f(network.angles[t]);
      t -= network.angles.size();
      return f(network.volumes[t]);
    }


    struct FirstNode
    {
      const SpringNetwork &network;

      unsigned int
      operator()(const LengthSpring &spring) const
      {
        return network.i[spring.position];
      }

      unsigned int
      operator()(const LengthCoupling &coupling) const
      {
        return network.i[coupling.a];
      }

      unsigned int
      operator()(const AngleSpring &spring) const
      {
        return spring.nodes[0];
      }

      unsigned int
      operator()(const VolumeSpring &spring) const
      {
        return spring.nodes[0];
      }
    };


    /** A generalised spring whose coordinate is @p q. */
    template <typename Gradient, typename Hessian>
    EnergyTerm
    spring_term(const std::vector<unsigned int> &nodes,
                const double k,
                const double q,
                const double q0,
                const Gradient &gradient,
                const Hessian &hessian)
    {
      return {nodes,
              spring_energy(k, q, q0),
              -spring_force(k, q, q0, gradient),
              spring_tangent(k, q, q0, gradient, hessian)};
    }


    template <int dim>
    struct Evaluate
    {
      const SpringNetwork &network;
      const Eigen::MatrixXd &displacement;

      Vector<dim>
      place(const unsigned int node) const
      {
        return network.nodes.col(node) + displacement.col(node);
      }

      std::optional<Elongation<dim>>
      elongation_of(const unsigned int spring) const
      {
        return elongation<dim>(network.law,
                               network.rest_length[spring],
                               place(network.j[spring]) -
                                 place(network.i[spring]));
      }

      std::optional<EnergyTerm>
      operator()(const LengthSpring &spring) const
      {
        const unsigned int s = spring.position;
        const auto q         = elongation_of(s);
        if (!q)
          return {};
        return spring_term({network.i[s], network.j[s]},
                           network.stiffness[s],
                           q->value,
                           0.,
                           q->gradient,
                           q->hessian);
      }

      std::optional<EnergyTerm>
      operator()(const LengthCoupling &coupling) const
      {
        const auto [a, b, k] = coupling;
        const auto q_a = elongation_of(a), q_b = elongation_of(b);
        if (!q_a || !q_b)
          return {};
        return EnergyTerm{
          {network.i[a], network.j[a], network.i[b], network.j[b]},
          coupling_energy(k, *q_a, *q_b),
          coupling_gradient(k, *q_a, *q_b),
          coupling_hessian(k, *q_a, *q_b)};
      }

      std::optional<EnergyTerm>
      operator()(const AngleSpring &spring) const
      {
        const auto [a, m, c] = spring.nodes;
        const Vector<dim> u  = place(a) - place(m);
        const Vector<dim> v  = place(c) - place(m);
        if (is_degenerate_angle<dim>(u, v))
          return {};
        return spring_term({a, m, c},
                           spring.stiffness,
                           angle<dim>(u, v),
                           spring.rest_angle,
                           angle_gradient<dim>(u, v),
                           angle_hessian<dim>(u, v));
      }

      std::optional<EnergyTerm>
      operator()(const VolumeSpring &spring) const
      {
        Eigen::MatrixXd points(dim, spring.nodes.size());
        for (std::size_t v = 0; v < spring.nodes.size(); ++v)
          points.col(v) = place(spring.nodes[v]);
        const CellKind kind = cell_kind(dim, spring.nodes.size());
        return spring_term(spring.nodes,
                           spring.stiffness,
                           volume(points, kind),
                           spring.rest_volume,
                           volume_gradient(points, kind),
                           volume_hessian(points, kind));
      }
    };
  } // namespace

  unsigned int
  n_terms(const SpringNetwork &network)
  {
    return network.stiffness.size() + network.couplings.size() +
           network.angles.size() + network.volumes.size();
  }

  unsigned int
  first_node(const SpringNetwork &network, const unsigned int term)
  {
    return with_part(network, term, FirstNode{network});
  }

  template <int dim>
  std::optional<EnergyTerm>
  evaluate_term(const SpringNetwork &network,
                const unsigned int term,
                const Eigen::MatrixXd &displacement)
  {
    return with_part(network, term, Evaluate<dim>{network, displacement});
  }

  template std::optional<EnergyTerm>
  evaluate_term<2>(const SpringNetwork &,
                   unsigned int,
                   const Eigen::MatrixXd &);
  template std::optional<EnergyTerm>
  evaluate_term<3>(const SpringNetwork &,
                   unsigned int,
                   const Eigen::MatrixXd &);
} // namespace springfit
