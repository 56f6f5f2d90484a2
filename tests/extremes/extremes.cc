// A great many random cells, each with a random fit: how many are certified,
// accepted or refused with a reason. Fails when anything else comes out of one,
// by arithmetic that is written here.
//
//   extremes [cells = 10000] [seed = 1] [number of a cell to show]

#include <springfit/core/error.h>
#include <springfit/fit/fit.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "checks.h"
#include "random_cells.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  struct Choice
  {
    const Method *method;
    FitOptions options;
  };

  /** A fit that suits the cell; Ipopt, which is slow, in few of them. */
  Choice
  random_choice(const CellKind kind, Random &random)
  {
    for (;;)
      {
        const auto &methods = method_words();
        Choice choice{
          methods[static_cast<int>(methods.size() * random())].first, {}};
        const auto &enrichments = enrichment_words();
        choice.options.enrichment =
          enrichments[static_cast<int>(enrichments.size() * random())].first;
        choice.options.nonnegative = random() < 0.5;
        choice.options.volume_law =
          random() < 0.5 ? VolumeLaw::quadratic : VolumeLaw::logarithmic;
        choice.options.norm = random() < 0.1 ? Norm::spectral : Norm::frobenius;
        choice.options.engine =
          random() < 0.03 ? Engine::ipopt : Engine::barrier;
        if (suits(*choice.method, kind) &&
            suits(*choice.method, choice.options.enrichment))
          return choice;
      }
  }

  std::string
  describe(const ExtremeCell &cell, const Choice &choice)
  {
    const auto &problem = cell.problem;
    char text[200];
    std::snprintf(
      text,
      sizeof(text),
      "%s, %s, nu %.5g, %s + %s%s%s, corner %.2e",
      cell.description.c_str(),
      singular(problem.kind).c_str(),
      problem.material.poissons_ratio,
      choice.method->word.c_str(),
      word_of(enrichment_words(), choice.options.enrichment).c_str(),
      choice.options.nonnegative ? ", k >= 0" : "",
      choice.options.engine == Engine::ipopt ? ", Ipopt" : "",
      smallest_corner(problem.points, problem.kind));
    return text;
  }

  /** The sentence without its numbers. */
  std::string
  kind_of(const std::string &message)
  {
    std::string text;
    for (const char c : message.substr(0, message.find('.')))
      if ((c < '0' || c > '9') && c != '-')
        text += c;
    return text;
  }
} // namespace

int
main(int argc, char *argv[])
{
  const std::uint32_t n_cells = argc > 1 ? std::atol(argv[1]) : 10000;
  const std::uint32_t seed    = argc > 2 ? std::atol(argv[2]) : 1;
  const long shown            = argc > 3 ? std::atol(argv[3]) : -1;

  std::map<std::string, unsigned int> reasons;
  unsigned int n_certified = 0, n_accepted = 0, n_refused = 0, n_others = 0;
  for (std::uint32_t i = 0; i < n_cells; ++i)
    {
      if (shown >= 0 && i != shown)
        continue;
      Random random(seed * 1000003u + i);
      const auto cell   = extreme_cell(random);
      const auto choice = random_choice(cell.problem.kind, random);
      std::string objection;
      try
        {
          const auto result = fit(cell.problem, *choice.method, choice.options);
          check_certificate(result, choice.options);
          objection =
            objection_to(result, cell.problem, *choice.method, choice.options);
          if (objection.empty())
            ++(result.duality_gap ? n_certified : n_accepted);
          if (shown >= 0)
            std::printf("frobenius %g spectral %g gap %g smallest %g\n",
                        result.frobenius_residual,
                        result.spectral_residual,
                        result.duality_gap.value_or(-1.),
                        result.smallest_eigenvalue.value_or(-9.));
        }
      catch (const RunError &error)
        {
          ++n_refused;
          ++reasons[kind_of(error.what()) + " (" + choice.method->word + ")"];
          if (shown >= 0)
            std::printf("%s\n", error.what());
        }
      catch (const std::exception &error)
        {
          objection = std::string("it throws: ") + error.what();
        }
      if (shown >= 0)
        std::printf("%s\n", describe(cell, choice).c_str());
      if (!objection.empty())
        {
          ++n_others;
          if (n_others <= 40)
            std::printf("cell %u: %s; %s\n",
                        i,
                        objection.c_str(),
                        describe(cell, choice).c_str());
        }
    }
  std::printf("certified %u\naccepted %u\nrefused %u\n",
              n_certified,
              n_accepted,
              n_refused);
  for (const auto &[reason, n] : reasons)
    std::printf("  %u: %s\n", n, reason.c_str());
  std::printf("others %u\n", n_others);
  return n_others == 0 ? 0 : 1;
}
