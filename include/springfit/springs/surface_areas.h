#ifndef springfit_springs_surface_areas_h
#define springfit_springs_surface_areas_h

#include <springfit/springs/family.h>

namespace springfit
{
  // Springs whose coordinate is the area A of a triangle in space, m^2: what
  // the kinds of volumes.h are in the plane, with the same columns, but that an
  // area in space has no sign.

  /** The energy k (A - rest_volume)^2 / 2. */
  const SpringKind &
  surface_areas();

  /** See logarithmic_volumes(). */
  const SpringKind &
  logarithmic_surface_areas();

  /** See logarithmic_areas_in_plane_stress(). */
  const SpringKind &
  logarithmic_surface_areas_in_plane_stress();
} // namespace springfit

#endif
