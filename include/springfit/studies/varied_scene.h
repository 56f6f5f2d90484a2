#ifndef springfit_studies_varied_scene_h
#define springfit_studies_varied_scene_h

#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/stability_section.h>

namespace springfit
{
  /**
   * The mesh and the materials of a scene at a point of a study of stability:
   * sizes, aspect ratios and angles move the vertices, contrasts give the half
   * of the cells whose centres have a large x a material of its own. Axes of
   * states and of motions change nothing here. The networks are still to come.
   *
   * @throws EntryError as Geometry::create() and scene_of() do.
   */
  template <int dim, int spacedim>
  CalibratedScene<dim, spacedim>
  varied_scene(const Scene<spacedim> &scene,
               const Variation &variation,
               MPI_Comm communicator);
} // namespace springfit

#endif
