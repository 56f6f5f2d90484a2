#ifndef springfit_output_gnuplot_h
#define springfit_output_gnuplot_h

#include <filesystem>
#include <string>

namespace springfit
{
  /**
   * Let gnuplot run a @p script in a folder, which makes the pictures of
   * @p page there.
   *
   * @return what is wrong and what to do, or nothing
   */
  std::string
  draw(const std::filesystem::path &folder,
       const std::string &script,
       const std::string &page);
} // namespace springfit

#endif
