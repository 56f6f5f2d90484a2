#ifndef springfit_output_tradeoff_page_h
#define springfit_output_tradeoff_page_h

#include <springfit/comparison/tradeoff.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What a page says of the reference. */
  struct ReferenceFacts
  {
    std::string material_law;
    unsigned int degree;
    std::string cells;
    double cell_size; // m
    unsigned int n_nodes;
    std::optional<double> own_error; // per cent
    std::vector<std::string> load_cases;
    std::string quantity; // empty: none
  };

  /** In two sentences. */
  std::string
  describe(const ReferenceFacts &facts);

  /** tradeoff.md, with the numbers of the table, and tradeoff.gp. */
  void
  write_page(const std::filesystem::path &folder,
             const std::vector<TradeoffRow> &rows,
             const Demand &demand,
             const Advice &advice,
             const ReferenceFacts &facts);
} // namespace springfit

#endif
