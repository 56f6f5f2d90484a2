#include <springfit/core/error.h>
#include <springfit/fit/cell/definiteness.h>
#include <springfit/fit/cell/several_states.h>
#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/negative.h>

#include <limits>
#include <sstream>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    std::optional<double>
    states_residual(const FitProblem &problem, const CellModel &model)
    {
      if (problem.states.empty())
        return {};
      return residual_over_states(problem, model);
    }

    /**
     * What rounding may do to an eigenvalue of a sum of tangents c g g^T,
     * relative to ||R||_2.
     */
    double
    rounding_of_eigenvalues(const FitProblem &problem, const CellModel &model)
    {
      const auto magnitudes =
        with_constants(model.families, constants_of(model.families).cwiseAbs());
      return std::numeric_limits<double>::epsilon() *
             Eigen::MatrixXd(tangent(magnitudes, problem.points)).trace() /
             spectral_norm(problem.stiffness);
    }

    std::string
    too_stiff(const double spectral_residual)
    {
      std::ostringstream text;
      text.precision(3);
      text << "its springs are " << spectral_residual
           << " times as stiff as the cell in some deformation.";
      return text.str();
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
  } // namespace


  FitResult
  fit(const FitProblem &problem,
      const Method &method,
      const FitOptions &options)
  {
    const Eigen::MatrixXd &R = problem.stiffness;
    if (!R.allFinite() || R.isZero(0.))
      throw RunError("The stiffness of a cell is zero or not a number.",
                     "Check the material and the shape of the cell.");

    for (const auto &state : problem.states)
      if (!state.stiffness.allFinite())
        throw RunError("its stiffness in one of the 'States' is not a number.",
                       "Name smaller deformations.");

    if (!suits(method, problem.kind) || !suits(method, options.enrichment) ||
        (!problem.states.empty() &&
         !has_states(method, options.enrichment, problem.kind)))
      throw std::logic_error("a fit is not for these cells or does not have "
                             "this enrichment or states");

    const FittedCell found = method.fit(problem, options);
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
                           states_residual(problem, found.model),
                           found.by_other_engine};
    // Springs that are so far off say nothing of the cell.
    constexpr double no_result = 100.;
    if (result.spectral_residual > no_result)
      throw RunError(too_stiff(result.spectral_residual),
                     "Improve the mesh there, or take the fit 'frobenius' with "
                     "'Enrichment = coupling', which is exact in any cell.");

    // Angles of very flat cells cancel each other but for what they should be.
    if (options.enrichment == Enrichment::angles && options.nonnegative &&
        !has(method, Feature::formulas) &&
        *result.smallest_eigenvalue < rounding_of_eigenvalues(problem, result))
      throw RunError("rounding hides whether its angles leave it stiff in all "
                     "deformations: their tangents are much larger than their "
                     "sum.",
                     "Improve the mesh there, or fit without angles.");

    // All its couplings make a cell its finite element, but for rounding.
    const bool is_exact =
      options.enrichment == Enrichment::coupling && problem.states.empty();
    if (!has(method, Feature::formulas) && options.nonnegative && !is_exact &&
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
