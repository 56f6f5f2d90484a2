#ifndef springfit_mesh_boundary_groups_h
#define springfit_mesh_boundary_groups_h

#include <springfit/mesh/mesh_description.h>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * A named part of the boundary: the sides listed, and every side all of whose
   * vertices are listed.
   */
  struct BoundaryGroup
  {
    std::string name;
    std::vector<std::vector<unsigned int>> sides; // each in ascending order
    std::vector<unsigned int> vertices;

    /** The id of the sides that belong to no other group; 0 for any. */
    unsigned int number = 0;
  };

  /**
   * Replace the facets of @p mesh and the names of its boundaries by what the
   * groups say. Sides of the same groups have the same id: the group's number,
   * if they are of one and it has one, else the next free one from 1; those of
   * none have 0. Where groups overlap, an id has several names. Groups without
   * a side on the boundary become unused names, with the reason; a warning
   * counts sides that are inside the body, and one those of no group.
   *
   * @throws InputError when more than two cells share a side.
   */
  void
  label_boundary_groups(MeshDescription &mesh,
                        const std::vector<BoundaryGroup> &groups);
} // namespace springfit

#endif
