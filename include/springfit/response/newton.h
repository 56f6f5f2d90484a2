#ifndef springfit_response_newton_h
#define springfit_response_newton_h

#include <springfit/response/discretization.h>
#include <springfit/response/distributed_body.h>
#include <springfit/response/linear_solver.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** Where Newton's method came to. */
  template <int dim>
  struct NewtonResult
  {
    Eigen::MatrixXd displacement; // m, dim x n_nodes

    /** The forces left over before each step and at the end, N. */
    std::vector<double> residuals;

    /** Empty when it converged; otherwise why not, without a full stop. */
    std::string failure;
  };

  /**
   * A stationary point of U(u) - f . u by Newton's method with the exact
   * tangent and a backtracking line search on that energy (Nocedal and Wright
   * 2006, algorithm 3.1), from @p start. Where the tangent's step leads uphill
   * or cannot be computed, the convex tangent's is taken. Near the end, where
   * differences of the energy drown in rounding, a step that halves the forces
   * left over is accepted as well.
   *
   * @param forces f, zero where it is held
   * @param tolerance for the norm of the forces left over, N; as much as
   * rounding errors leave over is accepted too, be it more
   */
  template <int dim>
  NewtonResult<dim>
  newton(const Discretization<dim> &discretization,
         DistributedBody<dim> &body,
         const SolverFactory<dim> &make_solver,
         const typename Discretization<dim>::Vector &forces,
         const Eigen::MatrixXd &start,
         double tolerance);
} // namespace springfit

#endif
