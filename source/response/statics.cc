#include <springfit/core/error.h>
#include <springfit/core/words.h>
#include <springfit/response/statics.h>
#include <springfit/response/stiffness_matrices.h>

#include <deal.II/base/timer.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace springfit
{
  namespace
  {
    const WordTable<Kinematics> &
    kinematics_words()
    {
      static const WordTable<Kinematics> table = {
        {Kinematics::linear, "linear"}};
      return table;
    }

    const WordTable<SolverChoice> &
    solver_words()
    {
      static const WordTable<SolverChoice> table = {
        {SolverChoice::automatic, "automatic"},
        {SolverChoice::direct, "direct"},
        {SolverChoice::cg, "cg"}};
      return table;
    }

    RunError
    not_found(const ModelWords &words, const std::string &reason)
    {
      return RunError("The equilibrium of " + words.name +
                        " was not found: " + reason,
                      words.advice);
    }

    /** Do @p work; a failure of the solver is said in the model's words. */
    template <typename Work>
    auto
    explaining(const ModelWords &words, const Work &work)
    {
      try
        {
          return work();
        }
      catch (const RunError &error)
        {
          throw not_found(words, error.what());
        }
    }

    ModelWords
    words_of_finite_elements()
    {
      return {"the finite element model",
              "A part of the object can move without resistance: check the "
              "mesh and the supports."};
    }

    ModelWords
    words_of_springs(const std::string &fit)
    {
      return {"the springs of the fit '" + fit + "'",
              "Springs of negative stiffness may cancel the others: set "
              "'Nonnegative = true' in section Fit, or 'Solver = direct' in "
              "section Response, or ask for another fit."};
    }
  } // namespace

  template <int dim>
  LinearModel<dim>::LinearModel(const Discretization<dim> &discretization,
                                std::unique_ptr<Matrix> matrix,
                                std::unique_ptr<LinearSolver<dim>> solver,
                                const ModelWords &words,
                                const double seconds)
    : discretization_(discretization)
    , matrix_(std::move(matrix))
    , solver_(std::move(solver))
    , words_(words)
    , seconds_(seconds)
  {}

  template <int dim>
  Equilibrium
  LinearModel<dim>::respond(const Eigen::MatrixXd &forces) const
  {
    dealii::Timer timer(discretization_.communicator());
    const auto right_hand_side = discretization_.to_vector(forces);
    const auto displacement =
      explaining(words_, [&]() { return solver_->solve(right_hand_side); });

    auto residual = right_hand_side;
    matrix_->residual(residual, displacement, right_hand_side);
    const double relative =
      residual.l2_norm() / (right_hand_side.l2_norm() + 1e-300);
    if (!(relative < 1e-6))
      {
        std::ostringstream reason;
        reason << "the forces left over are " << relative << " of the load.";
        throw not_found(words_, reason.str());
      }
    timer.stop();
    return {discretization_.to_nodal(displacement),
            seconds_ + timer.wall_time()};
  }

  template <int dim>
  Statics<dim>::Statics() : dealii::ParameterAcceptor("Response")
  {
    add_parameter("Kinematics",
                  kinematics_word_,
                  "Geometry of the deformation: " +
                    join(words_of(kinematics_words()), " or ") + " (no unit).");
    add_parameter("Solver",
                  solver_word_,
                  "Solver of the linear systems: " +
                    join(words_of(solver_words()), " or ") +
                    " (no unit). Direct is Trilinos' KLU, cg conjugate "
                    "gradients with algebraic multigrid; automatic takes cg "
                    "from 100,000 unknowns in 2-d and 10,000 in 3-d.");
    add_parameter("Tolerance",
                  tolerance_,
                  "For cg: the forces left over, relative to the load (no "
                  "unit), between 1e-15 and 1e-6.");
    parse_parameters_call_back.connect([this]() { check(); });
  }

  template <int dim>
  const std::string &
  Statics<dim>::kinematics() const
  {
    return kinematics_word_;
  }

  template <int dim>
  void
  Statics<dim>::check() const
  {
    value_of(kinematics_words(), kinematics_word_, "Response/Kinematics");
    value_of(solver_words(), solver_word_, "Response/Solver");
    if (!(tolerance_ >= 1e-15 && tolerance_ <= 1e-6))
      {
        std::ostringstream value;
        value << tolerance_;
        throw EntryError("Response/Tolerance",
                         value.str() + " is out of range.",
                         "Give a number between 1e-15 and 1e-6.");
      }
  }

  template <int dim>
  std::unique_ptr<LinearSolver<dim>>
  Statics<dim>::solver(const Discretization<dim> &discretization,
                       const typename Discretization<dim>::Matrix &matrix) const
  {
    const auto choice =
      value_of(solver_words(), solver_word_, "Response/Solver");
    const unsigned int largest_direct = dim == 2 ? 100000 : 10000;
    if (choice == SolverChoice::direct ||
        (choice == SolverChoice::automatic && matrix.m() < largest_direct))
      return make_direct_solver<dim>(matrix);
    return make_cg_solver<dim>(discretization, matrix, tolerance_);
  }

  namespace
  {
    /** Assemble a matrix, make its solver and keep the time of both. */
    template <int dim, typename Assemble, typename MakeSolver>
    LinearModel<dim>
    make_model(const Discretization<dim> &discretization,
               const ModelWords &words,
               const Assemble &assemble,
               const MakeSolver &make_solver)
    {
      dealii::Timer timer(discretization.communicator());
      auto matrix = std::make_unique<typename Discretization<dim>::Matrix>();
      discretization.initialize(*matrix);
      assemble(*matrix);
      auto solver = explaining(words, [&]() { return make_solver(*matrix); });
      timer.stop();
      return LinearModel<dim>(discretization,
                              std::move(matrix),
                              std::move(solver),
                              words,
                              timer.wall_time());
    }
  } // namespace

  template <int dim>
  LinearModel<dim>
  Statics<dim>::finite_elements(const Discretization<dim> &discretization,
                                const Element<dim> &element,
                                const MaterialTable &materials) const
  {
    return make_model(
      discretization,
      words_of_finite_elements(),
      [&](auto &matrix) {
        assemble_finite_elements(discretization, element, materials, matrix);
      },
      [&](const auto &matrix) { return solver(discretization, matrix); });
  }

  template <int dim>
  LinearModel<dim>
  Statics<dim>::springs(const Discretization<dim> &discretization,
                        const SpringNetwork &network,
                        const std::string &name) const
  {
    return make_model(
      discretization,
      words_of_springs(name),
      [&](auto &matrix) { assemble_springs(discretization, network, matrix); },
      [&](const auto &matrix) { return solver(discretization, matrix); });
  }

  template class LinearModel<2>;
  template class LinearModel<3>;
  template class Statics<2>;
  template class Statics<3>;
} // namespace springfit
