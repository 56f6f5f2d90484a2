#include <springfit/core/error.h>
#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/coupled_cell.h>
#include <springfit/fit/cell/definiteness.h>
#include <springfit/fit/cell/several_states.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>
#include <springfit/springs/network.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace springfit
{
  namespace
  {
    std::vector<DeformedState>
    all_states(const FitProblem &problem)
    {
      std::vector<DeformedState> states = problem.states;
      states.insert(states.begin(),
                    {Eigen::MatrixXd::Zero(problem.points.rows(),
                                           problem.points.cols()),
                     problem.stiffness});
      return states;
    }

    /** The entries of K(x_p), of all states one below the other. */
    Eigen::VectorXd
    stacked_tangents(const FitProblem &problem, const CellModel &model)
    {
      const auto states    = all_states(problem);
      const Eigen::Index n = problem.stiffness.size();
      Eigen::VectorXd entries(n * states.size());
      for (std::size_t p = 0; p < states.size(); ++p)
        entries.segment(n * p, n) =
          tangent(problem, model, states[p].displacement).reshaped();
      return entries;
    }

    /** The same of R(x_p). */
    Eigen::VectorXd
    stacked_references(const FitProblem &problem)
    {
      const auto states    = all_states(problem);
      const Eigen::Index n = problem.stiffness.size();
      Eigen::VectorXd entries(n * states.size());
      for (std::size_t p = 0; p < states.size(); ++p)
        entries.segment(n * p, n) = states[p].stiffness.reshaped();
      return entries;
    }

    /**
     * The constants c of models that are to be added up, each given with a
     * constant of one.
     */
    Eigen::VectorXd
    fit_models(const FitProblem &problem,
               const std::vector<CellModel> &models,
               const Eigen::Index n_nonnegative)
    {
      const Eigen::VectorXd d = stacked_references(problem);
      Eigen::MatrixXd A(d.size(), models.size());
      for (std::size_t m = 0; m < models.size(); ++m)
        A.col(m) = stacked_tangents(problem, models[m]);
      return nonnegative_least_squares(A.transpose() * A,
                                       A.transpose() * d,
                                       n_nonnegative);
    }
  } // namespace

  Eigen::MatrixXd
  tangent(const FitProblem &problem,
          const CellModel &model,
          const Eigen::MatrixXd &displacement)
  {
    const Eigen::MatrixXd x = problem.points + displacement;
    if (!std::isfinite(energy(model.families, x)))
      throw RunError("in one of the 'States' a length is zero or an angle "
                     "straight or folded.",
                     "Name smaller deformations.");
    return Eigen::MatrixXd(tangent(model.families, x));
  }


  double
  residual_over_states(const FitProblem &problem, const CellModel &model)
  {
    const Eigen::VectorXd R = stacked_references(problem);
    return (R - stacked_tangents(problem, model)).norm() / R.norm();
  }


  CellModel
  fit_over_states(const FitProblem &problem,
                  const CellTerms &terms,
                  const Eigen::Index n_nonnegative)
  {
    const Eigen::Index n = terms.norms.size();
    std::vector<CellModel> models;
    for (Eigen::Index m = 0; m < n; ++m)
      models.push_back(make_cell_model(terms, Eigen::VectorXd::Unit(n, m)));
    return make_cell_model(terms, fit_models(problem, models, n_nonnegative));
  }


  CellModel
  fit_coupled_over_states(const FitProblem &problem,
                          const Eigen::Index n_nonnegative)
  {
    const unsigned int n = problem.springs.size();
    std::vector<LengthCoupling> couplings;
    std::vector<CellModel> models;
    for (unsigned int s = 0; s < n; ++s)
      models.push_back(coupled_model(problem, Eigen::VectorXd::Unit(n, s), {}));
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = a + 1; b < n; ++b)
        {
          couplings.push_back({a, b, 1.});
          models.push_back(coupled_model(problem,
                                         Eigen::VectorXd::Zero(n),
                                         {couplings.back()}));
        }

    const Eigen::VectorXd c = fit_models(problem, models, n_nonnegative);
    for (std::size_t m = 0; m < couplings.size(); ++m)
      couplings[m].stiffness = c[n + m];
    return coupled_model(problem, c.head(n), couplings);
  }


  namespace
  {
    CellModel
    fit_coupled(const FitProblem &problem, const FitOptions &options)
    {
      const Eigen::Index n_nonnegative =
        options.nonnegative ? problem.springs.size() : 0;
      const CellModel found = fit_coupled_over_states(problem, n_nonnegative);
      if (!options.nonnegative ||
          is_definite(smallest_eigenvalue(problem, found)))
        return found;
      // At rest it equals the reference.
      return furthest_definite(problem, fit_coupled_cell(problem), found);
    }
  } // namespace


  FittedCell
  fit_states(const FitProblem &problem, const FitOptions &options)
  {
    if (options.enrichment == Enrichment::coupling)
      return {fit_coupled(problem, options)};
    return approximate(
      problem,
      options,
      [&problem](const CellTerms &terms, const Eigen::Index n_nonnegative) {
        return FittedCell{fit_over_states(problem, terms, n_nonnegative)};
      });
  }
} // namespace springfit
