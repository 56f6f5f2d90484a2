#include <springfit/core/error.h>
#include <springfit/fit/cell/barrier_engine.h>
#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/cell/certificate.h>
#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/definiteness.h>
#include <springfit/fit/cell/ipopt_engine.h>
#include <springfit/fit/cell/spectral_fit.h>
#include <springfit/springs/rigid_modes.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace springfit
{
  namespace
  {
    /**
     * The central path's parameter to stop at. A gap there is (2n + n_springs)
     * mu at most, at most 64 mu.
     */
    double
    final_mu(const double tolerance)
    {
      return std::clamp(1e-4 * tolerance, 1e-12, 1e-10);
    }

    struct Attempt
    {
      SpectralSolution solution;
      double gap = std::numeric_limits<double>::infinity();
    };

    Attempt
    solve(const SpectralProblem &problem,
          const Engine engine,
          const double tolerance)
    {
      const double mu = final_mu(tolerance);
      Attempt attempt;
      attempt.solution = engine == Engine::ipopt
                           ? solve_by_ipopt(problem, mu)
                           : solve_by_barrier(problem, mu);
      attempt.gap      = duality_gap(problem, attempt.solution);
      return attempt;
    }

    /** The problem of a cell by the engine asked for, or else by the other. */
    FittedCell
    solve(const CellTerms &terms,
          const SpectralProblem &problem,
          const FitOptions &options)
    {
      const auto cell_of = [&](const Attempt &attempt) {
        FittedCell cell{make_cell_model(terms,
                                        problem.scale * attempt.solution.k),
                        attempt.gap};
        return cell;
      };
      std::optional<Attempt> first;
      std::optional<RunError> failure;
      try
        {
          first = solve(problem, options.engine, options.tolerance);
          if (first->gap <= options.tolerance)
            return cell_of(*first);
        }
      catch (const RunError &error)
        {
          failure = error;
        }

      try
        {
          const Attempt second =
            solve(problem,
                  options.engine == Engine::ipopt ? Engine::barrier
                                                  : Engine::ipopt,
                  options.tolerance);
          if (!first || !(second.gap >= first->gap))
            {
              FittedCell cell      = cell_of(second);
              cell.by_other_engine = true;
              return cell;
            }
        }
      catch (const RunError &)
        {
          if (!first)
            throw *failure;
        }
      return cell_of(*first);
    }
  } // namespace

  FittedCell
  fit_with_certificate(const FitProblem &problem,
                       const FitOptions &options,
                       const SpectralProblemOf spectral_problem)
  {
    if (options.enrichment == Enrichment::coupling)
      return {fit_coupled_cell(problem)};

    const CellTerms terms    = make_cell_terms(problem, options.enrichment);
    const auto fit_no_softer = [&](const Eigen::MatrixXd &least) {
      return solve(terms,
                   spectral_problem(problem.points,
                                    terms.gradients,
                                    problem.stiffness,
                                    options.nonnegative ? terms.n_springs : 0,
                                    least),
                   options);
    };

    const FittedCell found = fit_no_softer({});
    const double floor     = floor_of_eigenvalues(problem);
    if (!options.nonnegative ||
        smallest_eigenvalue(problem, found.model) >= floor)
      return found;
    const Eigen::MatrixXd Q = deformation_basis(problem.points);
    return fit_no_softer(floor * spectral_norm(problem.stiffness) * Q *
                         Q.transpose());
  }

  FittedCell
  fit_spectral(const FitProblem &problem, const FitOptions &options)
  {
    FittedCell cell =
      fit_with_certificate(problem, options, &make_spectral_problem);
    if (options.enrichment == Enrichment::coupling)
      cell.duality_gap = spectral_norm(residual(problem, cell.model)) /
                         spectral_norm(problem.stiffness);
    return cell;
  }
} // namespace springfit
