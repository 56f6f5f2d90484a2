#ifndef springfit_mesh_conformity_h
#define springfit_mesh_conformity_h

#include <springfit/mesh/mesh_description.h>

#include <vector>

namespace springfit
{
  /** A vertex inside a side of a cell that it is not a vertex of. */
  struct HangingVertex
  {
    unsigned int vertex;
    unsigned int cell; // the first one with such a side
  };


  /** Vertices at which cells touch that are not connected there. */
  struct NonconformingVertices
  {
    /**
     * Two or more different vertices at one position, in ascending order; the
     * positions in the order of their first vertices.
     */
    std::vector<std::vector<unsigned int>> doubled;

    /** In ascending order of the vertices. */
    std::vector<HangingVertex> hanging;
  };


  /**
   * The vertices on the boundary of @p mesh that coincide with others, and
   * those that lie within a side on the boundary: on an edge in the plane; on
   * a face or one of its edges in space, a quadrilateral face being the
   * bilinear patch or either of its two pairs of triangles. Where cells do not
   * share a whole side, that side is on the boundary even inside the body, so
   * this finds the nodes of half-refined cells and of cracks there too.
   *
   * Vertices coincide if they are apart by at most 1e-6 of the shortest edge
   * that meets there. One lies within a side if its distance is at most 1e-6
   * of the side's diameter and it is further than that from the side's
   * vertices; thin cells do not count, for the distance is at most 1e-3 of the
   * shortest edge at the vertex, which is not one of the side's own cell. The
   * time is that of sorting, with boxes around the sides.
   *
   * @throws InputError when more than two cells share a side.
   */
  NonconformingVertices
  nonconforming_vertices(const MeshDescription &mesh);
} // namespace springfit

#endif
