#ifndef springfit_mesh_abaqus_groups_h
#define springfit_mesh_abaqus_groups_h

#include <springfit/mesh/abaqus_model.h>
#include <springfit/mesh/abaqus_syntax.h>

namespace springfit
{
  /**
   * The keywords that name nodes, elements and sides. Each adds to the instance
   * @p home, and throws InputError with the line of what cannot be understood.
   */

  /** *NSET. */
  void
  define_node_set(const AbaqusBlock &block, AbaqusInstance &home);

  /** *ELSET. */
  void
  define_element_set(const AbaqusBlock &block, AbaqusInstance &home);

  /** *SURFACE; false if it is not one of sides or of nodes. */
  bool
  define_surface(const AbaqusBlock &block, AbaqusInstance &home);
} // namespace springfit

#endif
