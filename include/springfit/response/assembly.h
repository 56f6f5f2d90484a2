#ifndef springfit_response_assembly_h
#define springfit_response_assembly_h

#include <springfit/response/discretization.h>
#include <springfit/response/elastic_body.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /** A body at a state, on the unknowns. */
  template <int dim>
  struct AssembledState
  {
    double energy; // J, of all ranks

    /** The forces in N that hold the state; zero where nodes are fixed. */
    typename Discretization<dim>::Vector forces;

    /**
     * The rounding errors in the norm of the forces, estimated, in N: what
     * errors of the nodes' places in the last digit change.
     */
    double rounding;
  };

  /**
   * The energy and the forces of @p body at @p displacement (m, dim x n_nodes),
   * and in @p tangent its tangent stiffness; rows of fixed nodes become
   * diagonal. Collective.
   *
   * @return nothing where the body has no finite energy; the tangent has no
   * meaning then.
   */
  template <int dim>
  std::optional<AssembledState<dim>>
  assemble(const Discretization<dim> &discretization,
           const ElasticBody &body,
           const Eigen::MatrixXd &displacement,
           typename Discretization<dim>::Matrix &tangent);

  /**
   * The tangent with the negative eigenvalues of each term left out: positive
   * semidefinite, so that its Newton step leads downhill everywhere (Teran,
   * Sifakis, Irving and Fedkiw 2005). @p displacement must have a finite
   * energy.
   */
  template <int dim>
  void
  assemble_convex_tangent(const Discretization<dim> &discretization,
                          const ElasticBody &body,
                          const Eigen::MatrixXd &displacement,
                          typename Discretization<dim>::Matrix &tangent);
} // namespace springfit

#endif
