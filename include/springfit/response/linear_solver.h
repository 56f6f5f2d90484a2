#ifndef springfit_response_linear_solver_h
#define springfit_response_linear_solver_h

#include <springfit/response/discretization.h>

#include <functional>
#include <memory>
#include <string>

namespace springfit
{
  /**
   * Solves K u = f with one matrix and any number of right hand sides. The
   * work that all of them share (factors, hierarchy) is done in the
   * constructor of the derived class, which keeps a reference to the matrix.
   */
  template <int dim>
  class LinearSolver
  {
  public:
    using Vector = typename Discretization<dim>::Vector;
    using Matrix = typename Discretization<dim>::Matrix;

    virtual ~LinearSolver() = default;

    /** @throws RunError with the reason when no solution is found. */
    virtual Vector
    solve(const Vector &forces) = 0;
  };

  /** How a model gets a solver for a matrix that it has assembled. */
  template <int dim>
  using SolverFactory = std::function<std::unique_ptr<LinearSolver<dim>>(
    const typename Discretization<dim>::Matrix &)>;

  /** Sparse LU factors by Trilinos' KLU. */
  template <int dim>
  std::unique_ptr<LinearSolver<dim>>
  make_direct_solver(const typename Discretization<dim>::Matrix &matrix);

  /**
   * Conjugate gradients to a residual of @p tolerance relative to the forces,
   * preconditioned by Trilinos' smoothed aggregation (ML), which is told the
   * rigid body modes as near null space.
   */
  template <int dim>
  std::unique_ptr<LinearSolver<dim>>
  make_cg_solver(const Discretization<dim> &discretization,
                 const typename Discretization<dim>::Matrix &matrix,
                 double tolerance);
} // namespace springfit

#endif
