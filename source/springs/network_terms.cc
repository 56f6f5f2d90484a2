#include <springfit/springs/angle.h>
#include <springfit/springs/coupling.h>
#include <springfit/springs/elongation.h>
#include <springfit/springs/generalised_spring.h>
#include <springfit/springs/network_terms.h>
#include <springfit/springs/volume.h>

#include <array>
#include <utility>

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


    // The coordinates that have no type of their own, at a state: like
    // Elongation, each derivative is computed when asked for.

    template <int dim>
    struct AngleCoordinate
    {
      Vector<dim> u;
      Vector<dim> v;

      double
      value() const
      {
        return angle<dim>(u, v);
      }

      Vector<3 * dim>
      gradient() const
      {
        return angle_gradient<dim>(u, v);
      }

      Tensor<3 * dim>
      hessian() const
      {
        return angle_hessian<dim>(u, v);
      }
    };

    struct VolumeCoordinate
    {
      Eigen::MatrixXd points;
      CellKind kind;

      double
      value() const
      {
        return volume(points, kind);
      }

      Eigen::VectorXd
      gradient() const
      {
        return volume_gradient(points, kind);
      }

      Eigen::MatrixXd
      hessian() const
      {
        return volume_hessian(points, kind);
      }
    };


    // Terms at a state: their nodes, and the energy's derivatives on demand.

    template <typename Nodes, typename Coordinate>
    struct SpringTerm
    {
      Nodes nodes;
      double k;
      double q0;
      Coordinate q;

      double
      energy() const
      {
        return spring_energy(k, q.value(), q0);
      }

      auto
      gradient() const
      {
        const auto grad_q = q.gradient();
        return (-spring_force(k, q.value(), q0, grad_q)).eval();
      }

      auto
      hessian() const
      {
        return spring_tangent(k, q.value(), q0, q.gradient(), q.hessian());
      }
    };

    template <typename Nodes, typename Coordinate>
    SpringTerm(Nodes, double, double, Coordinate)
      -> SpringTerm<Nodes, Coordinate>;

    template <int dim>
    struct CouplingTerm
    {
      std::array<unsigned int, 4> nodes;
      double k;
      Elongation<dim> a;
      Elongation<dim> b;

      double
      energy() const
      {
        return coupling_energy(k, a, b);
      }

      Vector<4 * dim>
      gradient() const
      {
        return coupling_gradient(k, a, b);
      }

      Tensor<4 * dim>
      hessian() const
      {
        return coupling_hessian(k, a, b);
      }
    };


    /**
     * Calls @p f with the term at the state that a part of the network is, if
     * it has derivatives there.
     *
     * @return whether it has.
     */
    template <int dim, typename F>
    struct AtState
    {
      const SpringNetwork &network;
      const Eigen::MatrixXd &displacement;
      const F &f;

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

      bool
      operator()(const LengthSpring &spring) const
      {
        const unsigned int s = spring.position;
        const auto q         = elongation_of(s);
        if (!q)
          return false;
        f(SpringTerm{NodePair{{network.i[s], network.j[s]}},
                     network.stiffness[s],
                     0.,
                     *q});
        return true;
      }

      bool
      operator()(const LengthCoupling &coupling) const
      {
        const auto [a, b, k] = coupling;
        const auto q_a = elongation_of(a), q_b = elongation_of(b);
        if (!q_a || !q_b)
          return false;
        f(CouplingTerm<dim>{
          {{network.i[a], network.j[a], network.i[b], network.j[b]}},
          k,
          *q_a,
          *q_b});
        return true;
      }

      bool
      operator()(const AngleSpring &spring) const
      {
        const auto [a, m, c]         = spring.nodes;
        const AngleCoordinate<dim> q = {place(a) - place(m),
                                        place(c) - place(m)};
        if (is_degenerate_angle<dim>(q.u, q.v))
          return false;
        f(SpringTerm{spring.nodes, spring.stiffness, spring.rest_angle, q});
        return true;
      }

      bool
      operator()(const VolumeSpring &spring) const
      {
        Eigen::MatrixXd points(dim, spring.nodes.size());
        for (std::size_t v = 0; v < spring.nodes.size(); ++v)
          points.col(v) = network.nodes.col(spring.nodes[v]) +
                          displacement.col(spring.nodes[v]);
        const CellKind kind = cell_kind(dim, spring.nodes.size());
        f(SpringTerm{spring.nodes,
                     spring.stiffness,
                     spring.rest_volume,
                     VolumeCoordinate{std::move(points), kind}});
        return true;
      }
    };

    template <int dim, typename F>
    bool
    at_state(const SpringNetwork &network,
             const unsigned int term,
             const Eigen::MatrixXd &displacement,
             const F &f)
    {
      return with_part(network,
                       term,
                       AtState<dim, F>{network, displacement, f});
    }
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
    std::optional<EnergyTerm> found;
    at_state<dim>(network, term, displacement, [&](const auto &state) {
      found = EnergyTerm{{state.nodes.begin(), state.nodes.end()},
                         state.energy(),
                         state.gradient(),
                         state.hessian()};
    });
    return found;
  }


  template <int dim>
  bool
  add_term_gradient(const SpringNetwork &network,
                    const unsigned int term,
                    const Eigen::MatrixXd &displacement,
                    Eigen::MatrixXd &gradient)
  {
    return at_state<dim>(network, term, displacement, [&](const auto &state) {
      const auto of_term = state.gradient();
      for (std::size_t a = 0; a < state.nodes.size(); ++a)
        gradient.col(state.nodes[a]) += of_term.template segment<dim>(dim * a);
    });
  }

  template std::optional<EnergyTerm>
  evaluate_term<2>(const SpringNetwork &,
                   unsigned int,
                   const Eigen::MatrixXd &);
  template std::optional<EnergyTerm>
  evaluate_term<3>(const SpringNetwork &,
                   unsigned int,
                   const Eigen::MatrixXd &);

  template bool
  add_term_gradient<2>(const SpringNetwork &,
                       unsigned int,
                       const Eigen::MatrixXd &,
                       Eigen::MatrixXd &);
  template bool
  add_term_gradient<3>(const SpringNetwork &,
                       unsigned int,
                       const Eigen::MatrixXd &,
                       Eigen::MatrixXd &);
} // namespace springfit
