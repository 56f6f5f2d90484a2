#ifndef springfit_response_statics_h
#define springfit_response_statics_h

#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/response/discretization.h>
#include <springfit/response/linear_solver.h>
#include <springfit/springs/network.h>

#include <deal.II/base/parameter_acceptor.h>

#include <Eigen/Core>

#include <memory>
#include <string>

namespace springfit
{
  /**
   * Where a model comes to rest, and what it costs to find out: the wall time
   * of the assembly, of the factors (or the hierarchy) and of this solution, as
   * if this load were the only one.
   */
  struct Equilibrium
  {
    Eigen::MatrixXd displacement; // m, dim x n_nodes
    double seconds;
  };


  /** How an error speaks of a model, and what it advises. */
  struct ModelWords
  {
    std::string name;
    std::string advice;
  };


  /** A model's linear response to forces, ready for any number of them. */
  template <int dim>
  class LinearModel
  {
  public:
    using Matrix = typename Discretization<dim>::Matrix;

    /**
     * @p seconds is the time that the assembly and the solver's set-up took.
     */
    LinearModel(const Discretization<dim> &discretization,
                std::unique_ptr<Matrix> matrix,
                std::unique_ptr<LinearSolver<dim>> solver,
                const ModelWords &words,
                double seconds);

    /**
     * The displacement under @p forces (N, dim x n_nodes), the time being that
     * of the assembly and of this solution.
     *
     * @throws RunError when there is none, or it is not found.
     */
    Equilibrium
    respond(const Eigen::MatrixXd &forces) const;

  private:
    const Discretization<dim> &discretization_;
    const std::unique_ptr<Matrix> matrix_;
    const std::unique_ptr<LinearSolver<dim>> solver_;
    const ModelWords words_;
    const double seconds_;
  };


  enum class Kinematics
  {
    linear
  };

  enum class SolverChoice
  {
    automatic,
    direct,
    cg
  };

  /** The section "Response": statics of both models on the same unknowns. */
  template <int dim>
  class Statics : public dealii::ParameterAcceptor
  {
  public:
    Statics();

    /** The word of the entry "Kinematics". */
    const std::string &
    kinematics() const;

    LinearModel<dim>
    finite_elements(const Discretization<dim> &discretization,
                    const Element<dim> &element,
                    const MaterialTable &materials) const;

    /** @p name is the fit's, for errors. */
    LinearModel<dim>
    springs(const Discretization<dim> &discretization,
            const SpringNetwork &network,
            const std::string &name) const;

  private:
    void
    check() const;

    /** The solver for a matrix, as asked for or by its size. */
    std::unique_ptr<LinearSolver<dim>>
    solver(const Discretization<dim> &discretization,
           const typename Discretization<dim>::Matrix &matrix) const;

    std::string kinematics_word_ = "linear";
    std::string solver_word_     = "automatic";
    double tolerance_            = 1e-10;
  };
} // namespace springfit

#endif
