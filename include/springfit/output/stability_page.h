#ifndef springfit_output_stability_page_h
#define springfit_output_stability_page_h

#include <springfit/output/stability_table.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** Which models are stable at all points, and what ends the others. */
  std::string
  safe_models(const std::vector<StabilityRow> &rows,
              const std::vector<StabilityBoundary> &boundaries);

  /**
   * stability.md, with a map of the verdicts for each axis, and stability.gp,
   * which makes a picture of each.
   */
  void
  write_stability_page(const std::filesystem::path &folder,
                       const std::vector<StabilityRow> &rows,
                       const std::vector<StabilityBoundary> &boundaries);
} // namespace springfit

#endif
