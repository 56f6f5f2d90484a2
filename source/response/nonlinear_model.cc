#include <springfit/core/error.h>
#include <springfit/response/distributed_body.h>
#include <springfit/response/members_at_supports.h>
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

    /**
     * Where the tangent at an equilibrium leads when the supports move on, so
     * that Newton's method does not begin with their cells crushed.
     *
     * @throws RunError when the tangent is singular.
     */
    template <int dim>
    Eigen::MatrixXd
    predicted(const Discretization<dim> &discretization,
              DistributedBody<dim> &body,
              const MembersAtSupports<dim> &at_supports,
              const SolverFactory<dim> &make_solver,
              const Eigen::MatrixXd &displacement,
              const Eigen::MatrixXd &motion)
    {
      typename Discretization<dim>::Matrix tangent;
      discretization.initialize(tangent);
      body.tangent(displacement, tangent);
      const auto pull = discretization.to_vector(
        -at_supports.tangent_product(displacement, motion));
      return displacement + motion +
             discretization.to_nodal(make_solver(tangent)->solve(pull));
    }
  } // namespace

  template <int dim>
  NonlinearModel<dim>::NonlinearModel(const Discretization<dim> &discretization,
                                      std::unique_ptr<const BodyOfMembers> body,
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
  NonlinearModel<dim>::respond(const NodalLoad &load) const
  {
    dealii::Timer timer(discretization_.communicator());
    const Eigen::MatrixXd rest =
      Eigen::MatrixXd::Zero(dim, discretization_.n_nodes());
    Equilibrium reached{rest, 0., rest, 0., {}};

    DistributedBody<dim> body(discretization_, *body_);
    const MembersAtSupports<dim> at_supports(discretization_, *body_);
    const bool moves = !load.support.isZero(0.);

    // What the forces left over are measured by: where nothing but the supports
    // moves, those that it takes to follow them.
    double scale = discretization_.to_vector(load.forces).l2_norm();
    if (moves)
      scale += discretization_
                 .to_vector(at_supports.tangent_product(rest, load.support))
                 .l2_norm();

    double step = first_step;
    while (reached.load_fraction < 1.)
      {
        const double target = std::min(1., reached.load_fraction + step);
        std::string objection;
        Eigen::MatrixXd start = reached.displacement;
        if (moves)
          try
            {
              start =
                predicted(discretization_,
                          body,
                          at_supports,
                          make_solver_,
                          reached.displacement,
                          (target - reached.load_fraction) * load.support);
            }
          catch (const RunError &)
            {
              objection = "the tangent stiffness is singular";
            }
        NewtonResult<dim> result;
        if (objection.empty())
          {
            result    = newton(discretization_,
                            body,
                            make_solver_,
                            discretization_.to_vector(target * load.forces),
                            start,
                            tolerance_ * target * scale);
            objection = result.failure.empty() ? judge_(result.displacement)
                                               : result.failure;
          }
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
    reached.reactions =
      at_supports.reactions(reached.displacement,
                            reached.load_fraction * load.forces);
    return reached;
  }

  template class NonlinearModel<2>;
  template class NonlinearModel<3>;
} // namespace springfit
