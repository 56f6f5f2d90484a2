#ifndef springfit_response_stability_h
#define springfit_response_stability_h

#include <springfit/response/elastic_body.h>
#include <springfit/springs/network.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace springfit
{
  /**
   * The number of independent motions of a held body that release energy, or
   * cost none, to second order: the eigenvalues <= 0 of its tangent at
   * @p displacement (m, dim x n_nodes), counted by the signs of a sparse
   * L D L^T factorisation (Sylvester's law of inertia). 0 is a stable state;
   * springs of negative stiffness, or of much compression, can make it
   * unstable.
   *
   * @p held has a flag per unknown, dim * v + d for component d of node v.
   */
  unsigned int
  n_unstable_motions(const ElasticBody &body,
                     const Eigen::MatrixXd &displacement,
                     const std::vector<bool> &held);

  /**
   * The same of a network at rest, without counting where springs of stiffness
   * >= 0 alone have none. Nothing for networks that are too large: counting
   * takes a direct factorisation.
   */
  std::optional<unsigned int>
  n_unstable_at_rest(const SpringNetwork &network,
                     const std::vector<bool> &held);
} // namespace springfit

#endif
