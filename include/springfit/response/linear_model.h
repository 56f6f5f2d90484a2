#ifndef springfit_response_linear_model_h
#define springfit_response_linear_model_h

#include <springfit/response/discretization.h>
#include <springfit/response/elastic_body.h>
#include <springfit/response/linear_solver.h>
#include <springfit/response/members_at_supports.h>
#include <springfit/response/model.h>

#include <memory>

namespace springfit
{
  /** A body's response with its stiffness at rest, for any number of loads. */
  template <int dim>
  class LinearModel : public Model
  {
  public:
    /** @throws RunError, in @p words, when the stiffness is singular. */
    LinearModel(const Discretization<dim> &discretization,
                const BodyOfMembers &body,
                const SolverFactory<dim> &make_solver,
                const ModelWords &words);

    Equilibrium
    respond(const NodalLoad &load) const override;

  private:
    const Discretization<dim> &discretization_;
    const ModelWords words_;
    const MembersAtSupports<dim> at_supports_;
    typename Discretization<dim>::Matrix stiffness_;
    std::unique_ptr<LinearSolver<dim>> solver_;
    double seconds_; // of assembly and factors
  };
} // namespace springfit

#endif
