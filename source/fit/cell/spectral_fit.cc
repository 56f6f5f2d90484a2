#include <springfit/fit/cell/barrier_engine.h>
#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/cell/certificate.h>
#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/definiteness.h>
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

    SpectralSolution
    solve(const SpectralProblem &problem, const FitOptions &options)
    {
      const double mu = final_mu(options.tolerance);
      return options.engine == Engine::ipopt ? solve_by_ipopt(problem, mu)
                                             : solve_by_barrier(problem, mu);
    }

    /** Equal springs that are as soft as a cell may be, N/m. */
    double
    least_spring(const FitProblem &problem)
    {
      const CellModel equal = equal_springs(problem);
      return floor_of_eigenvalues(problem) /
             smallest_eigenvalue(problem, equal) * equal.k()[0];
    }
  } // namespace

  FittedCell
  fit_with_certificate(const FitProblem &problem,
                       const FitOptions &options,
                       const SpectralProblemOf spectral_problem)
  {
    if (options.enrichment == Enrichment::coupling)
      return {fit_coupled_cell(problem)};

    const CellTerms terms     = make_cell_terms(problem, options.enrichment);
    const Eigen::MatrixXd &B  = terms.gradients;
    const Eigen::Index n_all  = terms.norms.size();
    const auto fit_at_or_over = [&](const Eigen::VectorXd &least,
                                    const Eigen::Index n_bounded) {
      // k = least + k', and k' >= 0 is fitted to what the least leaves.
      const Eigen::MatrixXd rest =
        problem.stiffness - B * least.asDiagonal() * B.transpose();
      const SpectralProblem of_rest =
        spectral_problem(problem.points, B, rest, n_bounded);
      const SpectralSolution solution = solve(of_rest, options);
      return FittedCell{make_cell_model(terms,
                                        least + of_rest.scale * solution.k),
                        duality_gap(of_rest, solution)};
    };

    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n_all);
    if (!options.nonnegative)
      return fit_at_or_over(zero, 0);

    const double floor = floor_of_eigenvalues(problem);
    for (const Eigen::Index n_bounded : {terms.n_springs, n_all})
      {
        const FittedCell found = fit_at_or_over(zero, n_bounded);
        if (smallest_eigenvalue(problem, found.model) >= floor)
          return found;
      }
    Eigen::VectorXd least = zero;
    least.head(terms.n_springs).setConstant(least_spring(problem));
    return fit_at_or_over(least, n_all);
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
