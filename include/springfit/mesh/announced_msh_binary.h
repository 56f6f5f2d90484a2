#ifndef springfit_mesh_announced_msh_binary_h
#define springfit_mesh_announced_msh_binary_h

#include <springfit/mesh/announced.h>

#include <filesystem>
#include <optional>
#include <string>

namespace springfit
{
  /**
   * announced_in_msh() of a binary file of @p version 2 or 4.1, in the order
   * of bytes of this machine.
   *
   * @throws InputError with what is wrong.
   */
  std::optional<Announced>
  announced_in_binary_msh(const std::filesystem::path &file,
                          const std::string &version);
} // namespace springfit

#endif
