#ifndef springfit_springs_network_terms_h
#define springfit_springs_network_terms_h

#include <springfit/core/energy_term.h>
#include <springfit/springs/network.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  // The elastic energy of a network as a sum of terms of a few nodes each: its
  // springs, couplings, angles and volumes, in this order.

  unsigned int
  n_terms(const SpringNetwork &network);

  /** The first node of a term, which stays the same whatever the state. */
  unsigned int
  first_node(const SpringNetwork &network, unsigned int term);

  /**
   * The true energy, forces and tangent of a term, stress stiffness included.
   *
   * @param displacement dim x n_nodes, m
   * @return nothing where the term has no derivatives: at a length (of the
   * quadratic law) of zero, at a straight or folded angle.
   */
  template <int dim>
  std::optional<EnergyTerm>
  evaluate_term(const SpringNetwork &network,
                unsigned int term,
                const Eigen::MatrixXd &displacement);

  /**
   * Add the gradient that evaluate_term() gives to those of the nodes: the
   * forces of the network are the opposite of the sum over its terms. Energy
   * and tangent are not computed: all that a step in time asks for.
   *
   * @param gradient dim x n_nodes, N
   * @return whether the term has derivatives; nothing is added otherwise.
   */
  template <int dim>
  bool
  add_term_gradient(const SpringNetwork &network,
                    unsigned int term,
                    const Eigen::MatrixXd &displacement,
                    Eigen::MatrixXd &gradient);
} // namespace springfit

#endif
