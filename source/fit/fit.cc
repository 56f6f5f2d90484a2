#include <springfit/fit/barrier_engine.h>
#include <springfit/fit/block.h>
#include <springfit/fit/certificate.h>
#include <springfit/fit/fit.h>
#include <springfit/fit/frobenius.h>
#include <springfit/fit/ipopt_engine.h>
#include <springfit/fit/spectral.h>
#include <springfit/springs/negative.h>

#include <algorithm>

namespace springfit
{
  namespace
  {
    /** k and, where there is a certificate, its gap. */
    struct Constants
    {
      Eigen::VectorXd k;
      std::optional<double> duality_gap;
    };

    Constants
    block(const FitProblem &problem, const FitOptions &options)
    {
      return {options.nonnegative ? fit_block_nonnegative(problem)
                                  : fit_block(problem),
              {}};
    }

    Constants
    frobenius(const FitProblem &problem, const FitOptions &options)
    {
      const Eigen::MatrixXd &B = problem.gradients;
      const Eigen::MatrixXd &R = problem.stiffness;
      return {options.nonnegative ? fit_frobenius_nonnegative(B, R)
                                  : fit_frobenius(B, R),
              {}};
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
      return {scaled.scale * solution.k, duality_gap(scaled, solution)};
    }

    Constants
    constants(const FitProblem &problem,
              const Method method,
              const FitOptions &options)
    {
      switch (method)
        {
          case Method::block:
            return block(problem, options);
          case Method::frobenius:
            return frobenius(problem, options);
          default:
            return spectral(problem, options);
        }
    }
  } // namespace


  const WordTable<Method> &
  method_words()
  {
    static const WordTable<Method> table = {{Method::block, "block"},
                                            {Method::frobenius, "frobenius"},
                                            {Method::spectral, "spectral"}};
    return table;
  }


  const WordTable<Engine> &
  engine_words()
  {
    static const WordTable<Engine> table = {{Engine::ipopt, "ipopt"},
                                            {Engine::barrier, "barrier"}};
    return table;
  }


  FitResult
  fit(const FitProblem &problem, const Method method, const FitOptions &options)
  {
    const Eigen::MatrixXd &R = problem.stiffness;
    if (!R.allFinite() || R.isZero(0.))
      throw RunError("The stiffness of a cell is zero or not a number.",
                     "Check the material and the shape of the cell.");

    const Constants found   = constants(problem, method, options);
    const Eigen::MatrixXd E = residual(problem, found.k);
    return {found.k,
            E.norm() / R.norm(),
            spectral_norm(E) / spectral_norm(R),
            found.duality_gap,
            n_negative(found.k)};
  }
} // namespace springfit
