// The certificate on many random cells of each kind, with and without k >= 0:
// prints a row of figures for each and fails when any cell misses its gap.
//
//   certified_gaps [cells per kind = 1000] [engine = ipopt] [kind = all]
//                  [enrichment = none]
//
// as in "certified_gaps 1000 barrier hexahedra volume".

#include <springfit/fit/fit.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "cells.h"

using namespace springfit;

namespace
{
  constexpr double required_gap = 1e-6;

  struct Figures
  {
    double worst                 = 0.;
    double mean                  = 0.;
    double worst_to_t            = 0.; // relative to t* where that is not tiny
    unsigned int n_failures      = 0;
    unsigned int n_with_negative = 0;
  };

  Figures
  run(const CellKind kind,
      const FitOptions &options,
      const unsigned int n_cells)
  {
    oracle::Random random(2010);
    Figures figures;
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      {
        const auto result = fit(oracle::random_problem(kind, random),
                                method_named("spectral"),
                                options);
        const double gap  = *result.duality_gap;
        figures.worst     = std::max(figures.worst, gap);
        figures.mean += gap / n_cells;
        if (result.spectral_residual > 1e-3)
          figures.worst_to_t =
            std::max(figures.worst_to_t, gap / result.spectral_residual);
        // A gap below zero by more than rounding would be a wrong bound.
        figures.n_failures += !(gap <= required_gap && gap > -1e-12);
        figures.n_with_negative += result.n_negative > 0;
      }
    return figures;
  }
} // namespace

int
main(int argc, char *argv[])
{
  const unsigned int n_cells = argc > 1 ? std::atoi(argv[1]) : 1000;
  FitOptions options;
  if (argc > 2)
    options.engine = value_of(engine_words(), argv[2], "engine");

  std::vector<CellKind> kinds = oracle::all_kinds;
  if (argc > 3 && std::string(argv[3]) != "all")
    kinds = {value_of(cell_kind_words(), argv[3], "kind")};
  if (argc > 4)
    options.enrichment = value_of(enrichment_words(), argv[4], "enrichment");

  unsigned int n_failures = 0;
  std::printf("%-14s %-7s %6s %10s %10s %13s %9s %13s\n",
              "cell",
              "k",
              "cells",
              "worst gap",
              "mean gap",
              "worst gap/t*",
              "failures",
              "with k < 0");
  for (const CellKind kind : kinds)
    for (const bool nonnegative : {false, true})
      {
        options.nonnegative   = nonnegative;
        const Figures figures = run(kind, options, n_cells);
        std::printf("%-14s %-7s %6u %10.1e %10.1e %13.1e %9u %13u\n",
                    singular(kind).c_str(),
                    nonnegative ? "k >= 0" : "free",
                    n_cells,
                    figures.worst,
                    figures.mean,
                    figures.worst_to_t,
                    figures.n_failures,
                    figures.n_with_negative);
        std::fflush(stdout);
        n_failures += figures.n_failures;
      }
  return n_failures == 0 ? 0 : 1;
}
