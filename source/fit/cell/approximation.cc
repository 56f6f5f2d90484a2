#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/definiteness.h>

namespace springfit
{
  FittedCell
  approximate(const FitProblem &problem,
              const FitOptions &options,
              const FitOfTerms &fit)
  {
    if (options.enrichment == Enrichment::coupling)
      return {fit_coupled_cell(problem)};

    const CellTerms terms = make_cell_terms(problem, options.enrichment);
    if (!options.nonnegative)
      return fit(terms, 0);

    const FittedCell wanted = fit(terms, terms.n_springs);
    if (is_definite(smallest_eigenvalue(problem, wanted.model)))
      return {without_mechanisms(problem, wanted.model)};
    const FittedCell safe = fit(terms, terms.norms.size());
    return {
      without_mechanisms(problem,
                         furthest_definite(problem, safe.model, wanted.model))};
  }
} // namespace springfit
