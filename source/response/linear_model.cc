#include <springfit/core/error.h>
#include <springfit/response/distributed_body.h>
#include <springfit/response/linear_model.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
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
  } // namespace

  template <int dim>
  LinearModel<dim>::LinearModel(const Discretization<dim> &discretization,
                                const BodyOfMembers &body,
                                const SolverFactory<dim> &make_solver,
                                const ModelWords &words)
    : discretization_(discretization)
    , words_(words)
    , at_supports_(discretization, body)
  {
    dealii::Timer timer(discretization.communicator());
    discretization.initialize(stiffness_);
    const Eigen::MatrixXd rest =
      Eigen::MatrixXd::Zero(dim, discretization.n_nodes());
    DistributedBody<dim> distributed(discretization, body);
    if (!std::isfinite(distributed.energy(rest)))
      throw not_found(words, "its energy at rest is not finite.");
    distributed.tangent(rest, stiffness_);
    solver_ = explaining(words_, [&]() { return make_solver(stiffness_); });
    timer.stop();
    seconds_ = timer.wall_time();
  }

  template <int dim>
  Equilibrium
  LinearModel<dim>::respond(const NodalLoad &load) const
  {
    dealii::Timer timer(discretization_.communicator());
    Eigen::MatrixXd forces = load.forces;
    if (!load.support.isZero(0.))
      forces -= at_supports_.tangent_product(
        Eigen::MatrixXd::Zero(forces.rows(), forces.cols()), load.support);
    const auto right_hand_side = discretization_.to_vector(forces);
    const auto displacement =
      explaining(words_, [&]() { return solver_->solve(right_hand_side); });

    auto residual = right_hand_side;
    stiffness_.residual(residual, displacement, right_hand_side);
    const double relative =
      residual.l2_norm() / (right_hand_side.l2_norm() + 1e-300);
    // Of very flat cells the forces of single springs and cells are so much
    // larger than their sums that rounding leaves over more than that.
    const double rounding = 1e-14 * stiffness_.linfty_norm() *
                            displacement.l2_norm() /
                            (right_hand_side.l2_norm() + 1e-300);
    if (!(relative < std::max(1e-6, std::min(rounding, 1e-3))))
      {
        std::ostringstream reason;
        reason << "the forces left over are " << relative << " of the load.";
        throw not_found(words_, reason.str());
      }
    timer.stop();
    Equilibrium found;
    found.displacement = load.support + discretization_.to_nodal(displacement);
    found.seconds      = seconds_ + timer.wall_time();
    found.reactions =
      at_supports_.linear_reactions(found.displacement, load.forces);
    return found;
  }

  template class LinearModel<2>;
  template class LinearModel<3>;
} // namespace springfit
