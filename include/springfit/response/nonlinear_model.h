#ifndef springfit_response_nonlinear_model_h
#define springfit_response_nonlinear_model_h

#include <springfit/response/discretization.h>
#include <springfit/response/elastic_body.h>
#include <springfit/response/linear_solver.h>
#include <springfit/response/model.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>

namespace springfit
{
  /**
   * A body's response with all nonlinearities of its energy: the load, with the
   * displacement of the supports, grows in steps that adapt, each solved by
   * Newton's method, along equilibria that are stable and that the judge
   * accepts.
   */
  template <int dim>
  class NonlinearModel : public Model
  {
  public:
    /** What is wrong with a state, without a full stop; empty: nothing. */
    using Judge = std::function<std::string(const Eigen::MatrixXd &)>;

    /**
     * @param judge is asked about every equilibrium, on all ranks
     * @param tolerance the forces left over, relative to the load
     */
    NonlinearModel(const Discretization<dim> &discretization,
                   std::unique_ptr<const BodyOfMembers> body,
                   const SolverFactory<dim> &make_solver,
                   const ModelWords &words,
                   Judge judge,
                   double tolerance);

    /**
     * Where the whole load is not reached, the result holds the largest part of
     * it that was, and says why not more.
     */
    Equilibrium
    respond(const NodalLoad &load) const override;

  private:
    const Discretization<dim> &discretization_;
    const std::unique_ptr<const BodyOfMembers> body_;
    const SolverFactory<dim> make_solver_;
    const ModelWords words_;
    const Judge judge_;
    const double tolerance_;
  };
} // namespace springfit

#endif
