#include <springfit/core/error.h>
#include <springfit/response/linear_solver.h>
#include <springfit/springs/rigid_modes.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

namespace springfit
{
  namespace
  {
    /** The rigid body modes of the nodes on the rows that a rank owns. */
    template <int dim>
    std::unique_ptr<Epetra_MultiVector>
    near_null_space(const Discretization<dim> &discretization,
                    const typename Discretization<dim>::Matrix &matrix)
    {
      const auto &vertices = discretization.nodes();
      Eigen::MatrixXd points(dim, vertices.size());
      for (unsigned int v = 0; v < vertices.size(); ++v)
        for (int d = 0; d < dim; ++d)
          points(d, v) = vertices[v][d];
      const Eigen::MatrixXd modes = rigid_body_modes(points);

      const auto &map = matrix.trilinos_matrix().OperatorDomainMap();
      auto null_space = std::make_unique<Epetra_MultiVector>(map, modes.cols());
      for (unsigned int v = 0; v < vertices.size(); ++v)
        for (int d = 0; d < dim; ++d)
          if (const int row =
                map.LID(static_cast<int>(discretization.dof(v, d)));
              row >= 0)
            for (Eigen::Index m = 0; m < modes.cols(); ++m)
              (*null_space)[m][row] = modes(dim * v + d, m);
      return null_space;
    }

    template <int dim>
    class CgSolver : public LinearSolver<dim>
    {
    public:
      using Vector = typename LinearSolver<dim>::Vector;
      using Matrix = typename LinearSolver<dim>::Matrix;

      CgSolver(const Discretization<dim> &discretization,
               const Matrix &matrix,
               const double tolerance)
        : matrix_(matrix)
        , tolerance_(tolerance)
        , null_space_(near_null_space(discretization, matrix))
      {
        dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
        data.elliptic              = true;
        data.smoother_sweeps       = 2;
        data.aggregation_threshold = 0.02;

        Teuchos::ParameterList parameters;
        std::unique_ptr<Epetra_MultiVector> constant_modes;
        data.set_parameters(parameters, constant_modes, matrix);
        parameters.set("null space: type", "pre-computed");
        parameters.set("null space: dimension", null_space_->NumVectors());
        // ML wants an address also on a rank that owns no rows.
        parameters.set("null space: vectors",
                       null_space_->MyLength() > 0 ? null_space_->Values()
                                                   : &no_rows_);
        parameters.set("PDE equations", dim);
        parameters.set("ML output", 0);
        try
          {
            preconditioner_.initialize(matrix, parameters);
          }
        catch (const dealii::ExceptionBase &)
          {
            throw RunError("no multigrid hierarchy could be made.");
          }
      }

      Vector
      solve(const Vector &forces) override
      {
        dealii::SolverControl control(2000, tolerance_ * forces.l2_norm());
        dealii::SolverCG<Vector> cg(control);
        Vector displacement(forces);
        displacement = 0.;
        try
          {
            cg.solve(matrix_, displacement, forces, preconditioner_);
          }
        catch (const dealii::SolverControl::NoConvergence &)
          {
            throw RunError("conjugate gradients did not converge in " +
                           std::to_string(control.last_step()) + " steps.");
          }
        catch (const dealii::ExceptionBase &)
          {
            throw RunError("conjugate gradients broke down: the matrix is not "
                           "positive definite.");
          }
        return displacement;
      }

    private:
      const Matrix &matrix_;
      const double tolerance_;
      double no_rows_ = 0.;
      const std::unique_ptr<Epetra_MultiVector> null_space_;
      dealii::TrilinosWrappers::PreconditionAMG preconditioner_;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<LinearSolver<dim>>
  make_cg_solver(const Discretization<dim> &discretization,
                 const typename Discretization<dim>::Matrix &matrix,
                 const double tolerance)
  {
    return std::make_unique<CgSolver<dim>>(discretization, matrix, tolerance);
  }

  template std::unique_ptr<LinearSolver<2>>
  make_cg_solver<2>(const Discretization<2> &,
                    const Discretization<2>::Matrix &,
                    double);
  template std::unique_ptr<LinearSolver<3>>
  make_cg_solver<3>(const Discretization<3> &,
                    const Discretization<3>::Matrix &,
                    double);
} // namespace springfit
