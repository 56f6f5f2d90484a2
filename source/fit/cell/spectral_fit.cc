#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/barrier_engine.h>
#include <springfit/fit/cell/certificate.h>
#include <springfit/fit/cell/ipopt_engine.h>
#include <springfit/fit/cell/spectral_fit.h>

#include <algorithm>

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
  } // namespace

  FittedCell
  solve(const SpectralProblem &problem,
        const CellTerms &terms,
        const FitOptions &options)
  {
    const double mu                 = final_mu(options.tolerance);
    const SpectralSolution solution = options.engine == Engine::ipopt
                                        ? solve_by_ipopt(problem, mu)
                                        : solve_by_barrier(problem, mu);
    return {make_cell_model(terms, problem.scale * solution.k),
            duality_gap(problem, solution)};
  }

  FittedCell
  fit_spectral(const FitProblem &problem, const FitOptions &options)
  {
    FittedCell cell =
      approximate(problem,
                  options,
                  [&](const CellTerms &terms,
                      const Eigen::Index n_nonnegative) {
                    return solve(make_spectral_problem(problem.points,
                                                       terms.gradients,
                                                       problem.stiffness,
                                                       n_nonnegative),
                                 terms,
                                 options);
                  });
    if (options.enrichment == Enrichment::coupling)
      cell.duality_gap = spectral_norm(residual(problem, cell.model)) /
                         spectral_norm(problem.stiffness);
    return cell;
  }
} // namespace springfit
