#ifndef springfit_mesh_abaqus_entities_h
#define springfit_mesh_abaqus_entities_h

#include <springfit/mesh/abaqus_elements.h>
#include <springfit/mesh/abaqus_model.h>
#include <springfit/mesh/abaqus_placement.h>
#include <springfit/mesh/abaqus_syntax.h>

#include <cstddef>

namespace springfit
{
  /**
   * The keywords that define nodes and elements. Each adds to @p instance, and
   * throws InputError with the line of what cannot be understood, is not
   * there, or is there already.
   */

  /**
   * *NODE; @p system_of_nodes is that of the *SYSTEM before. How many nodes
   * have fewer coordinates than others of the block; missing ones are 0.
   */
  std::size_t
  define_nodes(const AbaqusBlock &block,
               const AbaqusPlacement &system_of_nodes,
               AbaqusInstance &instance);

  /** *NGEN along straight lines. */
  void
  generate_nodes(const AbaqusBlock &block, AbaqusInstance &instance);

  /** *ELEMENT; @p block_number tells it from the others. */
  void
  define_elements(const AbaqusBlock &block,
                  const AbaqusElementType &type,
                  std::size_t block_number,
                  AbaqusInstance &instance);

  /** *ELGEN. */
  void
  generate_elements(const AbaqusBlock &block, AbaqusInstance &instance);

  /** *ELEMENT of a type without a shape; how many there are. */
  std::size_t
  skip_shapeless_elements(const AbaqusBlock &block, AbaqusInstance &instance);
} // namespace springfit

#endif
