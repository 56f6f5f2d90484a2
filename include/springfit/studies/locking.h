#ifndef springfit_studies_locking_h
#define springfit_studies_locking_h

#include <springfit/core/session.h>
#include <springfit/studies/calibrated_scene.h>

namespace springfit
{
  /**
   * Warn where the linear elements, which springs are fitted to and compared
   * with, are likely to lock: in bending of quadrilaterals and hexahedra, see
   * bending_ratio(), and near nu = 1/2 of triangles in plane strain and
   * tetrahedra.
   */
  template <int dim, int spacedim>
  void
  warn_of_locking(const Scene<spacedim> &scene,
                  const CalibratedScene<dim, spacedim> &calibrated,
                  Session &session);
} // namespace springfit

#endif
