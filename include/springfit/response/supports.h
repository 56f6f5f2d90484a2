#ifndef springfit_response_supports_h
#define springfit_response_supports_h

#include <springfit/mesh/mesh.h>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * Check that supports hold a mesh: that no part of it can move rigidly.
   *
   * A part are cells that hang together by faces (edges in 2-d): where cells
   * meet in fewer nodes they are hinged. A part is held by its own supports and
   * by the nodes that it shares with parts that are held already.
   *
   * @p held has a flag per unknown, spacedim * v + d for component d of node v;
   * @p entry names the parameter in the error.
   *
   * @throws EntryError naming the motion that is left.
   */
  template <int dim, int spacedim>
  void
  check_supports(const Mesh<dim, spacedim> &mesh,
                 const std::vector<bool> &held,
                 const std::string &entry);
} // namespace springfit

#endif
