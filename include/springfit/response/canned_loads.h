#ifndef springfit_response_canned_loads_h
#define springfit_response_canned_loads_h

#include <springfit/response/load_case.h>
#include <springfit/response/loaded_surface.h>

#include <deal.II/base/tensor.h>

namespace springfit
{
  /**
   * The traction of a canned case, 1 Pa at its largest: uniform along @p axis
   * (a unit vector: tension), against it (compression), or along the coordinate
   * direction most perpendicular to it (shear); for torsion the axis times the
   * distance vector from the surface's centroid, divided by its radius.
   */
  template <int dim, int spacedim>
  typename LoadedSurface<dim, spacedim>::Traction
  unit_traction(Load load,
                const dealii::Tensor<1, spacedim> &axis,
                const LoadedSurface<dim, spacedim> &surface);
} // namespace springfit

#endif
