#include <springfit/core/example_scene.h>

#include <filesystem>

namespace springfit
{
  std::string
  example_scene()
  {
    const std::filesystem::path scene = "parameters/cube.prm";
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto installed =
      program.parent_path().parent_path() / "share/springfit" / scene;
    return std::filesystem::exists(installed, error) ? installed.string()
                                                     : scene.string();
  }
} // namespace springfit
