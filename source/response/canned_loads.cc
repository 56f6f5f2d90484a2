#include <springfit/response/canned_loads.h>

#include <cmath>

namespace springfit
{
  namespace
  {
    /** The coordinate direction most perpendicular to @p axis, made so. */
    template <int dim>
    dealii::Tensor<1, dim>
    shear_direction(const dealii::Tensor<1, dim> &axis)
    {
      // The tolerance keeps the choice from hanging on rounding errors; among
      // equals the first direction after the axis' own is taken.
      int own = 0;
      for (int d = 1; d < dim; ++d)
        if (std::abs(axis[d]) > std::abs(axis[own]) + 1e-6)
          own = d;
      int best = (own + 1) % dim;
      for (int d = 0; d < dim; ++d)
        if (std::abs(axis[d]) < std::abs(axis[best]) - 1e-6)
          best = d;
      dealii::Tensor<1, dim> direction;
      direction[best] = 1.;
      direction -= (direction * axis) * axis;
      return direction / direction.norm();
    }
  } // namespace

  template <int dim, int spacedim>
  typename LoadedSurface<dim, spacedim>::Traction
  unit_traction(const Load load,
                const dealii::Tensor<1, spacedim> &axis,
                const LoadedSurface<dim, spacedim> &surface)
  {
    switch (load)
      {
        case Load::tension:
          return [axis](const auto &) { return axis; };
        case Load::compression:
          return [axis](const auto &) { return -axis; };
        case Load::shear:
          return [direction = shear_direction(axis)](const auto &) {
            return direction;
          };
        default:
          return [axis,
                  centroid = surface.centroid(),
                  radius   = surface.radius()](const auto &point) {
            dealii::Tensor<1, spacedim> traction;
            if constexpr (spacedim == 3)
              traction =
                dealii::cross_product_3d(axis, point - centroid) / radius;
            return traction;
          };
      }
  }

  template LoadedSurface<2>::Traction
  unit_traction(Load, const dealii::Tensor<1, 2> &, const LoadedSurface<2> &);
  template LoadedSurface<2, 3>::Traction
  unit_traction(Load,
                const dealii::Tensor<1, 3> &,
                const LoadedSurface<2, 3> &);
  template LoadedSurface<3>::Traction
  unit_traction(Load, const dealii::Tensor<1, 3> &, const LoadedSurface<3> &);
} // namespace springfit
