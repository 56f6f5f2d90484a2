#include <springfit/core/error.h>
#include <springfit/response/linear_solver.h>

#include <deal.II/lac/trilinos_solver.h>

namespace springfit
{
  namespace
  {
    template <int dim>
    class DirectSolver : public LinearSolver<dim>
    {
    public:
      using Vector = typename LinearSolver<dim>::Vector;
      using Matrix = typename LinearSolver<dim>::Matrix;

      explicit DirectSolver(const Matrix &matrix)
        : matrix_(matrix)
        , solver_(control_,
                  dealii::TrilinosWrappers::SolverDirect::AdditionalData(
                    false,
                    "Amesos_Klu"))
      {
        try
          {
            solver_.initialize(matrix);
          }
        catch (const dealii::ExceptionBase &)
          {
            throw RunError(
              "the stiffness matrix cannot be factored: it is singular, or the "
              "memory does not suffice.");
          }
      }

      Vector
      solve(const Vector &forces) override
      {
        Vector displacement = solve_by_factors(forces);

        // What rounding leaves over must not move anything to speak of. Where
        // it does, the displacements are arbitrary.
        Vector left_over(forces);
        matrix_.residual(left_over, displacement, forces);
        const Vector correction = solve_by_factors(left_over);
        if (!(correction.l2_norm() <= 1e-3 * displacement.l2_norm()))
          throw RunError("the stiffness matrix is singular to rounding.");
        displacement += correction;
        return displacement;
      }

    private:
      Vector
      solve_by_factors(const Vector &forces)
      {
        Vector displacement(forces);
        Vector right_hand_side(forces);
        try
          {
            solver_.solve(displacement, right_hand_side);
          }
        catch (const dealii::ExceptionBase &)
          {
            throw RunError("the factors of the stiffness matrix give no "
                           "solution.");
          }
        return displacement;
      }

      const Matrix &matrix_;
      dealii::SolverControl control_;
      dealii::TrilinosWrappers::SolverDirect solver_;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<LinearSolver<dim>>
  make_direct_solver(const typename Discretization<dim>::Matrix &matrix)
  {
    return std::make_unique<DirectSolver<dim>>(matrix);
  }

  template std::unique_ptr<LinearSolver<2>>
  make_direct_solver<2>(const Discretization<2>::Matrix &);
  template std::unique_ptr<LinearSolver<3>>
  make_direct_solver<3>(const Discretization<3>::Matrix &);
} // namespace springfit
