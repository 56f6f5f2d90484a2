// Time of one fit, averaged over 100 random cells of each kind: the
// counterpart of Table 2 of Natsupakpong and Cavusoglu 2010 (0.08 to 3 s per
// element for Frobenius' norm, 1.7 to 29 s for the 2-norm).

#include <springfit/fit/cell/barrier_engine.h>
#include <springfit/fit/cell/block.h>
#include <springfit/fit/cell/consistent.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/fit.h>

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "../unit/cells.h"

using namespace springfit;

namespace
{
  constexpr unsigned int n_cells = 100;

  using Fit = std::function<Eigen::VectorXd(const FitProblem &)>;

  /** Everything that `method_named("spectral")` does, its certificate included.
   */
  Fit
  spectral_fit(const Engine engine)
  {
    FitOptions options;
    options.engine = engine;
    return [options](const FitProblem &problem) {
      return fit(problem, method_named("spectral"), options).k();
    };
  }

  const std::vector<std::pair<std::string, Fit>> fits = {
    {"block",
     [](const FitProblem &problem) {
       return fit_block(problem.gradients,
                        problem.stiffness,
                        problem.points.rows(),
                        0);
     }},
    {"frobenius",
     [](const FitProblem &problem) {
       return fit_frobenius(problem.gradients, problem.stiffness, 0);
     }},
    {"frobenius nonnegative",
     [](const FitProblem &problem) {
       return fit_frobenius(problem.gradients,
                            problem.stiffness,
                            problem.gradients.cols());
     }},
    {"consistent nonnegative",
     [](const FitProblem &problem) {
       return fit_consistent(problem.points,
                             problem.gradients,
                             problem.stiffness,
                             problem.gradients.cols());
     }},
    {"spectral ipopt", spectral_fit(Engine::ipopt)},
    {"spectral barrier", spectral_fit(Engine::barrier)}};

  void
  time_fit(benchmark::State &state, const CellKind kind, const Fit &fit_cell)
  {
    oracle::Random random(2010);
    std::vector<FitProblem> problems;
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      problems.push_back(oracle::random_problem(kind, random));

    // Batches of all cells: the time shown is the average of one.
    while (state.KeepRunningBatch(n_cells))
      for (const auto &problem : problems)
        benchmark::DoNotOptimize(fit_cell(problem));
  }
} // namespace

int
main(int argc, char *argv[])
{
  for (const CellKind kind : oracle::all_kinds)
    for (const auto &[name, fit_cell] : fits)
      benchmark::RegisterBenchmark((name + "/" + singular(kind)).c_str(),
                                   time_fit,
                                   kind,
                                   fit_cell)
        ->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
