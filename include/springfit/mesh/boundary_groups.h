#ifndef springfit_mesh_boundary_groups_h
#define springfit_mesh_boundary_groups_h

#include <springfit/mesh/mesh_description.h>

#include <cstddef>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * A part of the boundary: the sides listed, and every side all of whose
   * vertices are listed. It has a name or a number, or both.
   */
  struct BoundaryGroup
  {
    std::string name;
    std::vector<std::vector<unsigned int>> sides; // each in ascending order
    std::vector<unsigned int> vertices;

    /** The id of the sides that belong to no other group; 0 for any. */
    unsigned int number = 0;

    /** Sides of the file with a vertex that no cell has. */
    std::size_t n_sides_without_cell = 0;
  };

  /**
   * Replace the facets of @p mesh and the names of its boundaries by what the
   * groups say. Sides of the same groups have the same id: the group's number,
   * if they are of one and it has one, else the next from 1 that is no group's
   * number; those of none have 0. Where groups overlap, an id has several
   * names, and a group without a name has its number for one: what names a
   * group means all its sides. Warnings tell where the number of a group with a
   * name means less, and count sides that are not on the boundary, and those of
   * no group. Groups without a side on the boundary become unused names, with
   * the reason.
   *
   * @throws InputError when more than two cells share a side.
   */
  void
  label_boundary_groups(MeshDescription &mesh,
                        const std::vector<BoundaryGroup> &groups);
} // namespace springfit

#endif
