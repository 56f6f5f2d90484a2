#include <springfit/core/error.h>
#include <springfit/response/newton.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace springfit
{
  namespace
  {
    constexpr unsigned int max_steps    = 40;
    constexpr unsigned int max_halvings = 16;

    /** The potential of the loaded body and its downhill forces at a state. */
    template <int dim>
    struct LoadedState
    {
      using Vector = typename Discretization<dim>::Vector;

      Eigen::MatrixXd displacement;
      double potential; // U - f . u, J
      Vector leftover;  // f - grad U, N
    };

    template <int dim>
    class LoadedBody
    {
    public:
      using Vector = typename Discretization<dim>::Vector;
      using Matrix = typename Discretization<dim>::Matrix;

      LoadedBody(const Discretization<dim> &discretization,
                 DistributedBody<dim> &body,
                 const SolverFactory<dim> &make_solver,
                 const Vector &forces)
        : discretization_(discretization)
        , body_(body)
        , make_solver_(make_solver)
        , forces_(forces)
      {
        discretization.initialize(tangent_);
      }

      /** Nothing where the body has no energy. */
      std::optional<LoadedState<dim>>
      at(const Eigen::MatrixXd &displacement) const
      {
        const double energy = body_.energy(displacement);
        if (!std::isfinite(energy))
          return {};
        LoadedState<dim> state{displacement,
                               energy - forces_ * discretization_.to_vector(
                                                    displacement),
                               forces_};
        state.leftover += body_.forces(displacement);
        if (!std::isfinite(state.leftover.l2_norm()))
          return {};
        return state;
      }

      /**
       * Go on from a state.
       *
       * @return the rounding errors in its leftover forces, N
       */
      double
      linearise(const LoadedState<dim> &state)
      {
        body_.tangent(state.displacement, tangent_);
        return body_.rounding(state.displacement, tangent_);
      }

      /** The way downhill from the state that was linearised. */
      std::optional<Vector>
      direction(const LoadedState<dim> &state)
      {
        if (auto exact = solve(state.leftover); exact)
          return exact;
        body_.convex_tangent(state.displacement, tangent_);
        return solve(state.leftover);
      }

    private:
      /** Nothing where there is no solution, or it leads uphill. */
      std::optional<Vector>
      solve(const Vector &leftover) const
      {
        try
          {
            auto direction = make_solver_(tangent_)->solve(leftover);
            if (direction * leftover > 0.)
              return direction;
          }
        catch (const RunError &)
          {}
        return {};
      }

      const Discretization<dim> &discretization_;
      DistributedBody<dim> &body_;
      const SolverFactory<dim> &make_solver_;
      const Vector &forces_;
      Matrix tangent_;
    };

    bool
    is_progress(const double potential,
                const double leftover,
                const double old_potential,
                const double old_leftover,
                const double expected)
    {
      return potential <= old_potential - 1e-4 * expected ||
             leftover <= 0.5 * old_leftover;
    }
  } // namespace

  template <int dim>
  NewtonResult<dim>
  newton(const Discretization<dim> &discretization,
         DistributedBody<dim> &body,
         const SolverFactory<dim> &make_solver,
         const typename Discretization<dim>::Vector &forces,
         const Eigen::MatrixXd &start,
         const double tolerance)
  {
    LoadedBody<dim> loaded(discretization, body, make_solver, forces);
    auto state = loaded.at(start);
    NewtonResult<dim> result{start, {}, {}};
    if (!state)
      {
        result.failure =
          "the displacement of the supports leaves it without an "
          "energy";
        return result;
      }
    for (unsigned int step = 0; step < max_steps; ++step)
      {
        const double leftover = state->leftover.l2_norm();
        result.residuals.push_back(leftover);
        const double rounding = loaded.linearise(*state);
        if (leftover <= std::max(tolerance, rounding))
          return result;

        const auto direction = loaded.direction(*state);
        if (!direction)
          {
            result.failure = "the tangent stiffness is singular";
            return result;
          }
        const Eigen::MatrixXd nodal = discretization.to_nodal(*direction);
        const double slope          = *direction * state->leftover;

        std::optional<LoadedState<dim>> next;
        double length         = 1.;
        unsigned int halvings = 0;
        for (; halvings <= max_halvings; ++halvings, length *= 0.5)
          {
            next = loaded.at(result.displacement + length * nodal);
            if (next && is_progress(next->potential,
                                    next->leftover.l2_norm(),
                                    state->potential,
                                    leftover,
                                    length * slope))
              break;
          }
        if (halvings > max_halvings)
          {
            result.failure = "no step of Newton's method leads further";
            return result;
          }
        state               = std::move(next);
        result.displacement = state->displacement;
      }
    result.failure = "Newton's method did not converge in " +
                     std::to_string(max_steps) + " steps";
    return result;
  }

  template struct NewtonResult<2>;
  template struct NewtonResult<3>;
  template NewtonResult<2>
  newton<2>(const Discretization<2> &,
            DistributedBody<2> &,
            const SolverFactory<2> &,
            const Discretization<2>::Vector &,
            const Eigen::MatrixXd &,
            double);
  template NewtonResult<3>
  newton<3>(const Discretization<3> &,
            DistributedBody<3> &,
            const SolverFactory<3> &,
            const Discretization<3>::Vector &,
            const Eigen::MatrixXd &,
            double);
} // namespace springfit
