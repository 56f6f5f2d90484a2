#ifndef springfit_mesh_abaqus_sets_h
#define springfit_mesh_abaqus_sets_h

#include <springfit/mesh/abaqus_model.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace springfit
{
  /** A node or an element: the number of its instance, and its label there. */
  using AbaqusItem = std::pair<unsigned int, std::size_t>;

  enum class AbaqusSetKind
  {
    nodes,
    elements
  };

  /** The members of a set, in ascending order. */
  struct AbaqusMembers
  {
    std::vector<AbaqusItem> items;
    std::size_t n_missing =
      0; // members that the file names but does not define
  };

  /**
   * The members of the set that @p name means in an instance: its own, or else,
   * outside of parts, those of that name in all instances. "instance.set" names
   * another instance's.
   *
   * @throws InputError with the reference's place when there is no such set, or
   * when it contains itself.
   */
  AbaqusMembers
  members_of_set(const AbaqusModel &model,
                 AbaqusSetKind kind,
                 unsigned int instance,
                 const AbaqusSet::Reference &reference);
} // namespace springfit

#endif
