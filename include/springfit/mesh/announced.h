#ifndef springfit_mesh_announced_h
#define springfit_mesh_announced_h

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

namespace springfit
{
  /** What a mesh file says that it holds. */
  struct Announced
  {
    std::size_t n_nodes = 0;

    /** By their dimension. */
    std::array<std::size_t, 4> n_elements = {{0, 0, 0, 0}};
  };

  /**
   * Look through a file that gmsh is going to read, because gmsh 4.8 passes
   * over in silence what is missing, doubled or not known: every node and every
   * element has a number of its own, elements have the nodes that they name,
   * counts are right, sections end. Nothing is said of
   * version 3 of .msh, and of types of elements that are not known.
   *
   * @throws InputError with what is wrong and, in a text file, its line.
   */
  std::optional<Announced>
  announced_in_msh(const std::filesystem::path &file);
} // namespace springfit

#endif
