#include <springfit/response/distributed_body.h>
#include <springfit/response/newton.h>
#include <springfit/response/nonlinear_model.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace springfit
{
  namespace
  {
    // Parts of the load. Small first steps keep Newton's method on the branch
    // of equilibria that starts at rest.
    constexpr double first_step    = 1. / 4.;
    constexpr double smallest_step = 1. / 128.;

    std::string
    failure_text(const ModelWords &words,
                 const double load_fraction,
                 const std::string &reason)
    {
      char percent[32];
      std::snprintf(percent, sizeof(percent), "%.3g", 100. * load_fraction);
      return "The equilibrium of " + words.name + " was not found beyond " +
             percent + " % of the load: " + reason + ". " + words.advice;
    }
  } // namespace

  template <int dim>
  NonlinearModel<dim>::NonlinearModel(const Discretization<dim> &discretization,
                                      std::unique_ptr<const ElasticBody> body,
                                      const SolverFactory<dim> &make_solver,
                                      const ModelWords &words,
                                      Judge judge,
                                      const double tolerance)
    : discretization_(discretization)
    , body_(std::move(body))
    , make_solver_(make_solver)
    , words_(words)
    , judge_(std::move(judge))
    , tolerance_(tolerance)
  {}

  template <int dim>
  Equilibrium
  NonlinearModel<dim>::respond(const Eigen::MatrixXd &forces) const
  {
    dealii::Timer timer(discretization_.communicator());
    Equilibrium reached{Eigen::MatrixXd::Zero(dim, discretization_.n_nodes()),
                        0.,
                        0.,
                        {}};

    DistributedBody<dim> body(discretization_, *body_);
    double step = first_step;
    while (reached.load_fraction < 1.)
      {
        const double target = std::min(1., reached.load_fraction + step);
        const auto result   = newton(discretization_,
                                   body,
                                   make_solver_,
                                   discretization_.to_vector(target * forces),
                                   reached.displacement,
                                   tolerance_);
        const std::string objection =
          result.failure.empty() ? judge_(result.displacement) : result.failure;
        if (objection.empty())
          {
            reached.displacement  = result.displacement;
            reached.load_fraction = target;
            step *= 2.;
          }
        else if ((step *= 0.5) < smallest_step)
          {
            reached.failure =
              failure_text(words_, reached.load_fraction, objection);
            break;
          }
      }
    timer.stop();
    reached.seconds = timer.wall_time();
    return reached;
  }

  template class NonlinearModel<2>;
  template class NonlinearModel<3>;
} // namespace springfit
