#ifndef springfit_mesh_announced_h
#define springfit_mesh_announced_h

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What a mesh file says that it holds. */
  struct Announced
  {
    std::size_t n_nodes = 0;

    /** By their dimension. */
    std::array<std::size_t, 4> n_elements = {{0, 0, 0, 0}};

    std::vector<std::string> warnings;
  };

  /**
   * Look through a file that gmsh is going to read, because gmsh 4.8 passes
   * over in silence what is missing, doubled or not known: every node and every
   * element has a number of its own, elements have the nodes that they name,
   * counts are right, sections end. Nothing is said of binary files and of
   * version 3 of .msh.
   *
   * @throws InputError with the line of what is wrong.
   */
  std::optional<Announced>
  announced_in_msh(const std::filesystem::path &file);

  /** The same of an I-deas universal file (.unv): data sets 2411 and 2412. */
  Announced
  announced_in_unv(const std::filesystem::path &file);

  /**
   * The same of a Nastran file (.bdf, .nas), in which INCLUDE and nodes in
   * other coordinate systems than the basic one are refused.
   */
  Announced
  announced_in_bdf(const std::filesystem::path &file);
} // namespace springfit

#endif
