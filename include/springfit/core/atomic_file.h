#ifndef springfit_core_atomic_file_h
#define springfit_core_atomic_file_h

#include <filesystem>
#include <functional>
#include <ostream>

namespace springfit
{
  /**
   * Write a file whole or not at all: @p write fills a file of a temporary
   * name in the same folder, which is renamed to @p path when every byte has
   * reached the system.
   *
   * @throws RunError when the file cannot be created, filled or renamed (the
   * temporary file is removed).
   */
  void
  write_file(const std::filesystem::path &path,
             const std::function<void(std::ostream &)> &write);
} // namespace springfit

#endif
