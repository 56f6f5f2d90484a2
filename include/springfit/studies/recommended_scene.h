#ifndef springfit_studies_recommended_scene_h
#define springfit_studies_recommended_scene_h

#include <springfit/comparison/tradeoff.h>

#include <filesystem>

namespace springfit
{
  /**
   * recommended.prm: the scene of the folder's used.prm with one model on one
   * mesh, for the purpose of the demand.
   */
  void
  write_recommended_scene(const std::filesystem::path &folder,
                          const TradeoffRow &row,
                          const Demand &demand);
} // namespace springfit

#endif
