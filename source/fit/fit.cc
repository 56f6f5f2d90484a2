#include <springfit/core/error.h>
#include <springfit/fit/cell/barrier_engine.h>
#include <springfit/fit/cell/baudet.h>
#include <springfit/fit/cell/block.h>
#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/cell/certificate.h>
#include <springfit/fit/object/compliance.h>
#include <springfit/fit/cell/consistent.h>
#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/definiteness.h>
#include <springfit/fit/cell/delingette.h>
#include <springfit/fit/fit.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/cell/gelder.h>
#include <springfit/fit/cell/golec.h>
#include <springfit/fit/cell/ipopt_engine.h>
#include <springfit/fit/cell/lloyd.h>
#include <springfit/fit/cell/several_states.h>
#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/springs/negative.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    /** A cell's forces and, where there is a certificate, its gap. */
    struct Constants
    {
      CellModel model;
      std::optional<double> duality_gap = {};
    };

    // Those of the cell's stiffness; n_nonnegative of the terms, from the first
    // on, must not be negative.

    Constants
    block(const FitProblem &problem,
          const CellTerms &terms,
          const Eigen::Index n_nonnegative)
    {
      return {make_cell_model(terms,
                              fit_block(terms.gradients,
                                        problem.stiffness,
                                        problem.points.rows(),
                                        n_nonnegative))};
    }

    Constants
    frobenius(const FitProblem &problem,
              const CellTerms &terms,
              const Eigen::Index n_nonnegative)
    {
      if (!problem.states.empty())
        return {fit_over_states(problem, terms, n_nonnegative)};
      return {make_cell_model(
        terms,
        fit_frobenius(terms.gradients, problem.stiffness, n_nonnegative))};
    }

    /**
     * The central path's parameter to stop at. A gap there is (2n + n_springs)
     * mu at most, at most 64 mu.
     */
    double
    final_mu(const double tolerance)
    {
      return std::clamp(1e-4 * tolerance, 1e-12, 1e-10);
    }

    Constants
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

    Constants
    spectral(const FitProblem &problem,
             const CellTerms &terms,
             const Eigen::Index n_nonnegative,
             const FitOptions &options)
    {
      return solve(make_spectral_problem(problem.points,
                                         terms.gradients,
                                         problem.stiffness,
                                         n_nonnegative),
                   terms,
                   options);
    }

    Constants
    consistent(const FitProblem &problem,
               const CellTerms &terms,
               const Eigen::Index n_nonnegative,
               const FitOptions &options)
    {
      if (options.norm == Norm::spectral && !is_simplex(problem.kind))
        return solve(make_consistent_spectral_problem(problem.points,
                                                      terms.gradients,
                                                      problem.stiffness,
                                                      n_nonnegative),
                     terms,
                     options);
      return {make_cell_model(terms,
                              fit_consistent(problem.points,
                                             terms.gradients,
                                             problem.stiffness,
                                             n_nonnegative))};
    }

    /** The cell as an object of its own. */
    Constants
    compliance(const FitProblem &problem,
               const CellTerms &terms,
               const Eigen::Index n_nonnegative)
    {
      std::vector<unsigned int> nodes(problem.points.cols());
      std::iota(nodes.begin(), nodes.end(), 0);
      ObjectProblem object{problem.points,
                           problem.stiffness.sparseView(),
                           {},
                           std::vector<bool>(terms.norms.size(), false)};
      std::fill_n(object.nonnegative.begin(), n_nonnegative, true);
      for (Eigen::Index t = 0; t < terms.norms.size(); ++t)
        object.terms.push_back(
          {nodes,
           0.,
           {},
           terms.gradients.col(t) * terms.gradients.col(t).transpose()});
      return {make_cell_model(terms, fit_compliance(object))};
    }

    // Those with formulas of their own, from the shape and the material.

    CellModel
    springs_alone(const FitProblem &problem, const Eigen::VectorXd &k)
    {
      return coupled_model(problem, k, {});
    }

    Constants
    gelder(const FitProblem &problem)
    {
      return {springs_alone(
        problem, fit_gelder(problem.points, problem.kind, problem.material))};
    }

    Constants
    lloyd(const FitProblem &problem)
    {
      return {springs_alone(
        problem, fit_lloyd(problem.points, problem.kind, problem.material))};
    }

    Constants
    baudet(const FitProblem &problem, const FitOptions &options)
    {
      std::vector<LengthCoupling> couplings;
      if (options.enrichment == Enrichment::coupling)
        couplings =
          baudet_couplings(problem.points, problem.kind, problem.material);
      return {coupled_model(
        problem,
        fit_baudet(problem.points, problem.kind, problem.material),
        couplings)};
    }

    Constants
    delingette(const FitProblem &problem, const FitOptions &options)
    {
      std::vector<LengthCoupling> couplings;
      if (options.enrichment == Enrichment::coupling)
        couplings = delingette_couplings(problem.points, problem.material);
      return {coupled_model(problem,
                            fit_delingette(problem.points, problem.material),
                            couplings)};
    }

    Constants
    golec(const FitProblem &problem)
    {
      CellModel model =
        springs_alone(problem, fit_golec(problem.points, problem.material));
      model.families.push_back(volume_at_rest(
        problem.points,
        problem.kind,
        golec_volume_stiffness(problem.points, problem.material)));
      return {model};
    }


    Constants
    to_stiffness(const FitProblem &problem,
                 const Method method,
                 const CellTerms &terms,
                 const Eigen::Index n_nonnegative,
                 const FitOptions &options)
    {
      switch (method)
        {
          case Method::block:
            return block(problem, terms, n_nonnegative);
          case Method::frobenius:
            return frobenius(problem, terms, n_nonnegative);
          case Method::spectral:
            return spectral(problem, terms, n_nonnegative, options);
          case Method::consistent:
            return consistent(problem, terms, n_nonnegative, options);
          case Method::compliance:
            return compliance(problem, terms, n_nonnegative);
          default:
            throw std::logic_error("a fit of formulas knows no stiffness");
        }
    }

    Constants
    stable_neo_hookean(const FitProblem &problem, const FitOptions &options)
    {
      return {options.enrichment == Enrichment::point_volumes
                ? fit_stable_neo_hookean_points(problem, options.volume_law)
                : fit_stable_neo_hookean_volume(problem, options.volume_law)};
    }


    Constants
    from_formulas(const FitProblem &problem,
                  const Method method,
                  const FitOptions &options)
    {
      switch (method)
        {
          case Method::stable_neo_hookean:
            return stable_neo_hookean(problem, options);
          case Method::gelder:
            return gelder(problem);
          case Method::lloyd:
            return lloyd(problem);
          case Method::baudet:
            return baudet(problem, options);
          case Method::delingette:
            return delingette(problem, options);
          case Method::golec:
            return golec(problem);
          default:
            throw std::logic_error("a fit has no formulas of its own");
        }
    }

    /**
     * A cell with all its couplings is exact: whatever the norm, the fit is the
     * same and leaves nothing.
     */
    Constants
    coupled(const FitProblem &problem, const Method method)
    {
      Constants found{fit_coupled_cell(problem)};
      if (method == Method::spectral)
        found.duality_gap = spectral_norm(residual(problem, found.model)) /
                            spectral_norm(problem.stiffness);
      return found;
    }

    /** A cell with all its couplings that shall suit several states. */
    Constants
    coupled_over_states(const FitProblem &problem, const FitOptions &options)
    {
      const Eigen::Index n_nonnegative =
        options.nonnegative ? problem.springs.size() : 0;
      const CellModel found = fit_coupled_over_states(problem, n_nonnegative);
      if (!options.nonnegative ||
          is_definite(smallest_eigenvalue(problem, found)))
        return {found};
      // At rest it equals the reference.
      return {furthest_definite(problem, fit_coupled_cell(problem), found)};
    }

    Constants
    approximate(const FitProblem &problem,
                const Method method,
                const FitOptions &options)
    {
      if (options.enrichment == Enrichment::coupling)
        return problem.states.empty() ? coupled(problem, method)
                                      : coupled_over_states(problem, options);

      const auto terms = make_cell_terms(problem, options.enrichment);
      const auto fit   = [&](const Eigen::Index n_nonnegative) {
        return to_stiffness(problem, method, terms, n_nonnegative, options);
      };
      if (!options.nonnegative)
        return fit(0);

      const Constants found = fit(terms.n_springs);
      if (is_definite(smallest_eigenvalue(problem, found.model)))
        return found;
      // Volumes or angles so negative that the cell gives way. With all
      // constants >= 0 it cannot.
      const Constants safe = fit(terms.norms.size());
      // A certificate holds for an end of the way only.
      if (safe.duality_gap)
        return safe;
      return {furthest_definite(problem, safe.model, found.model)};
    }

    std::optional<double>
    states_residual(const FitProblem &problem, const CellModel &model)
    {
      if (problem.states.empty())
        return {};
      return residual_over_states(problem, model);
    }

    std::string
    not_definite(const double eigenvalue, const FitOptions &options)
    {
      std::ostringstream text;
      text.precision(3);
      text << "its springs with '"
           << word_of(enrichment_words(), options.enrichment)
           << "' release energy in a deformation: the smallest eigenvalue is "
           << eigenvalue << " of the cell's largest one.";
      return text.str();
    }

    template <typename Value>
    bool
    contains(const std::vector<Value> &values, const Value value)
    {
      return std::find(values.begin(), values.end(), value) != values.end();
    }
  } // namespace


  const WordTable<Engine> &
  engine_words()
  {
    static const WordTable<Engine> table = {{Engine::ipopt, "ipopt"},
                                            {Engine::barrier, "barrier"}};
    return table;
  }


  const WordTable<Norm> &
  norm_words()
  {
    static const WordTable<Norm> table = {{Norm::frobenius, "frobenius"},
                                          {Norm::spectral, "spectral"}};
    return table;
  }


  FitResult
  fit(const FitProblem &problem, const Method method, const FitOptions &options)
  {
    const Eigen::MatrixXd &R = problem.stiffness;
    if (!R.allFinite() || R.isZero(0.))
      throw RunError("The stiffness of a cell is zero or not a number.",
                     "Check the material and the shape of the cell.");

    for (const auto &state : problem.states)
      if (!state.stiffness.allFinite())
        throw RunError("its stiffness in one of the 'States' is not a number.",
                       "Name smaller deformations.");

    if (!contains(cells_of(method), problem.kind) ||
        !contains(enrichments_of(method), options.enrichment) ||
        (!problem.states.empty() &&
         !has_states(method, options.enrichment, problem.kind)))
      throw std::logic_error("a fit is not for these cells or does not have "
                             "this enrichment or states");

    const Constants found = has_formulas(method)
                              ? from_formulas(problem, method, options)
                              : approximate(problem, method, options);
    if (!all_finite(found.model.families))
      throw RunError("its constants are not finite.",
                     "Improve the mesh there, or choose another material.");

    const Eigen::MatrixXd E = residual(problem, found.model);
    const FitResult result{{found.model},
                           E.norm() / R.norm(),
                           spectral_norm(E) / spectral_norm(R),
                           found.duality_gap,
                           smallest_eigenvalue(problem, found.model),
                           n_negative(found.model.families),
                           states_residual(problem, found.model)};
    // All its couplings make a cell its finite element, but for rounding.
    const bool is_exact =
      options.enrichment == Enrichment::coupling && problem.states.empty();
    if (!has_formulas(method) && options.nonnegative && !is_exact &&
        !is_definite(*result.smallest_eigenvalue))
      throw RunError(not_definite(*result.smallest_eigenvalue, options),
                     "Improve the mesh there, or choose another material.");
    return result;
  }


  void
  check_certificate(const FitResult &result, const FitOptions &options)
  {
    if (!result.duality_gap || *result.duality_gap <= options.tolerance)
      return;
    std::ostringstream text;
    text << "its certified gap is " << *result.duality_gap
         << ", more than 'Tolerance' " << options.tolerance << '.';
    throw RunError(text.str(),
                   "Improve the mesh there, raise 'Tolerance' in section Fit, "
                   "or choose another 'Engine'.");
  }
} // namespace springfit
