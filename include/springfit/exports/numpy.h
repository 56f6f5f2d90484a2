#ifndef springfit_exports_numpy_h
#define springfit_exports_numpy_h

#include <springfit/exports/exported_scene.h>

#include <filesystem>

namespace springfit
{
  /**
   * <name>.npz, which numpy.load() reads: nodes, support and forces (n x 3),
   * held (n x 3, 0 or 1), mass (n), and for each family <word>_law,
   * <word>_nodes (m x nodes of a member) and its columns <word>_<column> (m, or
   * m x width); of a motion its numbers (see ExportedMotion). Every network can
   * be held.
   *
   * @throws RunError when the file cannot be written.
   */
  void
  write_numpy(const std::filesystem::path &folder, const ExportedScene &scene);
} // namespace springfit

#endif
