#include <springfit/core/error.h>
#include <springfit/fit/barrier_engine.h>
#include <springfit/fit/baudet.h>
#include <springfit/fit/block.h>
#include <springfit/fit/certificate.h>
#include <springfit/fit/delingette.h>
#include <springfit/fit/fit.h>
#include <springfit/fit/frobenius.h>
#include <springfit/fit/gelder.h>
#include <springfit/fit/golec.h>
#include <springfit/fit/ipopt_engine.h>
#include <springfit/fit/lloyd.h>
#include <springfit/fit/spectral.h>
#include <springfit/springs/negative.h>

#include <algorithm>
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

    Constants
    block(const FitProblem &problem, const FitOptions &options)
    {
      return {{options.nonnegative ? fit_block_nonnegative(problem)
                                   : fit_block(problem)}};
    }

    Constants
    frobenius(const FitProblem &problem, const FitOptions &options)
    {
      const Eigen::MatrixXd &B = problem.gradients;
      const Eigen::MatrixXd &R = problem.stiffness;
      return {{options.nonnegative ? fit_frobenius_nonnegative(B, R)
                                   : fit_frobenius(B, R)}};
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
    spectral(const FitProblem &problem, const FitOptions &options)
    {
      const SpectralProblem scaled =
        make_spectral_problem(problem, options.nonnegative);
      const double mu                 = final_mu(options.tolerance);
      const SpectralSolution solution = options.engine == Engine::ipopt
                                          ? solve_by_ipopt(scaled, mu)
                                          : solve_by_barrier(scaled, mu);
      return {{scaled.scale * solution.k}, duality_gap(scaled, solution)};
    }

    // The published ones, from the shape and the material.

    Constants
    gelder(const FitProblem &problem, const FitOptions &)
    {
      return {{fit_gelder(problem.points, problem.kind, problem.material)}};
    }

    Constants
    lloyd(const FitProblem &problem, const FitOptions &)
    {
      return {{fit_lloyd(problem.points, problem.kind, problem.material)}};
    }

    Constants
    baudet(const FitProblem &problem, const FitOptions &options)
    {
      CellModel model{
        fit_baudet(problem.points, problem.kind, problem.material)};
      if (options.enrichment == Enrichment::coupling)
        model.couplings =
          baudet_couplings(problem.points, problem.kind, problem.material);
      return {model};
    }

    Constants
    delingette(const FitProblem &problem, const FitOptions &options)
    {
      CellModel model{fit_delingette(problem.points, problem.material)};
      if (options.enrichment == Enrichment::coupling)
        model.couplings =
          delingette_couplings(problem.points, problem.material);
      return {model};
    }

    Constants
    golec(const FitProblem &problem, const FitOptions &)
    {
      CellModel model{fit_golec(problem.points, problem.material)};
      model.volume_stiffness =
        golec_volume_stiffness(problem.points, problem.material);
      return {model};
    }


    // Their assumptions, with the same arguments for all of them.

    using Assumptions = std::vector<std::string>;

    Assumptions
    none_unmet(const Eigen::MatrixXd &,
               const CellKind,
               const IsotropicMaterial &)
    {
      return {};
    }

    Assumptions
    golec_unmet(const Eigen::MatrixXd &,
                const CellKind,
                const IsotropicMaterial &material)
    {
      return golec_assumptions(material);
    }


    struct Description
    {
      Method method;
      std::string word;
      bool published;
      std::vector<CellKind> cells;
      std::vector<Enrichment> enrichments;
      Constants (*constants)(const FitProblem &, const FitOptions &);
      Assumptions (*unmet)(const Eigen::MatrixXd &,
                           CellKind,
                           const IsotropicMaterial &);
    };

    /** In the order in which they are offered. */
    const std::vector<Description> &
    descriptions()
    {
      const auto triangle      = CellKind::triangle;
      const auto quadrilateral = CellKind::quadrilateral;
      const auto tetrahedron   = CellKind::tetrahedron;
      const auto hexahedron    = CellKind::hexahedron;
      const auto all      = {triangle, quadrilateral, tetrahedron, hexahedron};
      const auto none     = Enrichment::none;
      const auto volume   = Enrichment::volume;
      const auto coupling = Enrichment::coupling;
      static const std::vector<Description> table = {
        {Method::block, "block", false, all, {none}, &block, &none_unmet},
        {Method::frobenius,
         "frobenius",
         false,
         all,
         {none},
         &frobenius,
         &none_unmet},
        {Method::spectral,
         "spectral",
         false,
         all,
         {none},
         &spectral,
         &none_unmet},
        {Method::gelder,
         "gelder",
         true,
         {triangle, tetrahedron},
         {none},
         &gelder,
         &none_unmet},
        {Method::lloyd,
         "lloyd",
         true,
         {triangle, quadrilateral, tetrahedron},
         {none},
         &lloyd,
         &lloyd_assumptions},
        {Method::baudet,
         "baudet",
         true,
         {quadrilateral, hexahedron},
         {none, coupling},
         &baudet,
         &baudet_assumptions},
        {Method::delingette,
         "delingette",
         true,
         {triangle},
         {none, coupling},
         &delingette,
         &none_unmet},
        {Method::golec,
         "golec",
         true,
         {tetrahedron},
         {volume},
         &golec,
         &golec_unmet}};
      return table;
    }

    const Description &
    description(const Method method)
    {
      for (const auto &entry : descriptions())
        if (entry.method == method)
          return entry;
      throw std::logic_error("a fit has no description");
    }

    template <typename Value>
    bool
    contains(const std::vector<Value> &values, const Value value)
    {
      return std::find(values.begin(), values.end(), value) != values.end();
    }
  } // namespace


  const WordTable<Method> &
  method_words()
  {
    static const WordTable<Method> table = [] {
      WordTable<Method> words;
      for (const auto &entry : descriptions())
        words.emplace_back(entry.method, entry.word);
      return words;
    }();
    return table;
  }


  const WordTable<Enrichment> &
  enrichment_words()
  {
    static const WordTable<Enrichment> table = {{Enrichment::none, "none"},
                                                {Enrichment::volume, "volume"},
                                                {Enrichment::coupling,
                                                 "coupling"}};
    return table;
  }


  const WordTable<Engine> &
  engine_words()
  {
    static const WordTable<Engine> table = {{Engine::ipopt, "ipopt"},
                                            {Engine::barrier, "barrier"}};
    return table;
  }


  const std::vector<CellKind> &
  cells_of(const Method method)
  {
    return description(method).cells;
  }


  const std::vector<Enrichment> &
  enrichments_of(const Method method)
  {
    return description(method).enrichments;
  }


  bool
  is_published(const Method method)
  {
    return description(method).published;
  }


  std::vector<std::string>
  unmet_assumptions(const Method method,
                    const Eigen::MatrixXd &points,
                    const CellKind kind,
                    const IsotropicMaterial &material)
  {
    return description(method).unmet(points, kind, material);
  }


  FitResult
  fit(const FitProblem &problem, const Method method, const FitOptions &options)
  {
    const Eigen::MatrixXd &R = problem.stiffness;
    if (!R.allFinite() || R.isZero(0.))
      throw RunError("The stiffness of a cell is zero or not a number.",
                     "Check the material and the shape of the cell.");

    if (!contains(cells_of(method), problem.kind) ||
        !contains(enrichments_of(method), options.enrichment))
      throw std::logic_error("a fit is not for these cells or does not have "
                             "this enrichment");

    const Constants found   = description(method).constants(problem, options);
    const Eigen::MatrixXd E = residual(problem, found.model);
    return {found.model,
            E.norm() / R.norm(),
            spectral_norm(E) / spectral_norm(R),
            found.duality_gap,
            n_negative(found.model.k)};
  }
} // namespace springfit
