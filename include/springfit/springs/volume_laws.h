#ifndef springfit_springs_volume_laws_h
#define springfit_springs_volume_laws_h

#include <springfit/core/plane_stress.h>
#include <springfit/springs/family.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace springfit
{
  // The energy U of a volume V, and its derivatives, from the columns of a
  // family. A position counts the coordinates of all members. What each law is
  // stands in volumes.h.

  struct QuadraticVolumeLaw
  {
    static constexpr bool is_smooth_everywhere = true;

    static std::vector<Column>
    columns(const int dim, const unsigned int width)
    {
      return {{"k",
               dim == 2 ? "N/m^3" : "N/m^5",
               Column::Role::stiffness,
               -dim,
               width},
              {"rest_volume",
               dim == 2 ? "m^2" : "m^3",
               Column::Role::rest_value,
               dim,
               width}};
    }

    static std::string
    word()
    {
      return "quadratic";
    }

    static std::string
    prefix()
    {
      return "";
    }

    explicit QuadraticVolumeLaw(const Members &members)
      : k(members.columns[0].data()), rest_volume(members.columns[1].data())
    {}

    bool
    is_smooth(std::size_t, double) const
    {
      return true;
    }

    double
    energy(const std::size_t i, const double V) const
    {
      return 0.5 * k[i] * (V - rest_volume[i]) * (V - rest_volume[i]);
    }

    /** U' */
    double
    slope(const std::size_t i, const double V) const
    {
      return k[i] * (V - rest_volume[i]);
    }

    /** U'' */
    double
    curvature(const std::size_t i, double) const
    {
      return k[i];
    }

    const double *k;
    const double *rest_volume;
  };


  struct LogarithmicVolumeLaw
  {
    static constexpr bool is_smooth_everywhere = false;

    static std::vector<Column>
    columns(const int dim, const unsigned int width)
    {
      // In the plane of a thickness.
      const std::string of_lame = dim == 2 ? "N/m" : "Pa";
      return {{"mu", of_lame, Column::Role::parameter, 0, width},
              {"lambda", of_lame, Column::Role::parameter, 0, width},
              {"rest_volume",
               dim == 2 ? "m^2" : "m^3",
               Column::Role::rest_value,
               dim,
               width}};
    }

    static std::string
    word()
    {
      return "logarithmic";
    }

    static std::string
    prefix()
    {
      return "logarithmic_";
    }

    explicit LogarithmicVolumeLaw(const Members &members)
      : mu(members.columns[0].data())
      , lambda(members.columns[1].data())
      , rest_volume(members.columns[2].data())
    {}

    bool
    is_smooth(const std::size_t i, const double V) const
    {
      return V / rest_volume[i] > 0.;
    }

    double
    energy(const std::size_t i, const double V) const
    {
      const double log_J = std::log(V / rest_volume[i]);
      return rest_volume[i] * (-mu[i] + 0.5 * lambda[i] * log_J) * log_J;
    }

    double
    slope(const std::size_t i, const double V) const
    {
      const double J = V / rest_volume[i];
      return (-mu[i] + lambda[i] * std::log(J)) / J;
    }

    double
    curvature(const std::size_t i, const double V) const
    {
      const double J = V / rest_volume[i];
      return (mu[i] + lambda[i] * (1. - std::log(J))) /
             (J * J * rest_volume[i]);
    }

    const double *mu;
    const double *lambda;
    const double *rest_volume;
  };


  /**
   * With the square c of the stretch across the plane, J_3 = J c^(1/2) and
   * lambda_3 ln J_3 = mu (1 - c): U / rest_volume is
   * mu (c - 1) / 2 - mu ln J_3 + mu (1 - c) ln J_3 / 2, its derivative by J is
   * - mu c / J.
   */
  struct PlaneStressVolumeLaw
  {
    static constexpr bool is_smooth_everywhere = false;

    static std::vector<Column>
    columns(const int dim, const unsigned int width)
    {
      return LogarithmicVolumeLaw::columns(dim, width);
    }

    static std::string
    word()
    {
      return "logarithmic plane stress";
    }

    static std::string
    prefix()
    {
      return "logarithmic_plane_stress_";
    }

    explicit PlaneStressVolumeLaw(const Members &members) : data(members)
    {}

    bool
    is_smooth(const std::size_t i, const double V) const
    {
      return data.is_smooth(i, V) &&
             std::isfinite(squared_stretch(i, V / data.rest_volume[i]));
    }

    double
    energy(const std::size_t i, const double V) const
    {
      const double J     = V / data.rest_volume[i];
      const double c     = squared_stretch(i, J);
      const double log_J = std::log(J) + 0.5 * std::log(c);
      return 0.5 * data.rest_volume[i] * data.mu[i] *
             (c - 1. - (1. + c) * log_J);
    }

    double
    slope(const std::size_t i, const double V) const
    {
      const double J = V / data.rest_volume[i];
      return -data.mu[i] * squared_stretch(i, J) / J;
    }

    double
    curvature(const std::size_t i, const double V) const
    {
      const double J      = V / data.rest_volume[i];
      const double c      = squared_stretch(i, J);
      const double lambda = data.lambda[i], mu = data.mu[i];
      // dc / d(ln J) from the condition on the stretch.
      const double change = -lambda / (mu - 0.5 * lambda + 0.5 * lambda / c);
      return mu * (c - change) / (J * J * data.rest_volume[i]);
    }

    double
    squared_stretch(const std::size_t i, const double J) const
    {
      return squared_stretch_across(std::log(J), data.lambda[i], data.mu[i])
        .value_or(std::numeric_limits<double>::quiet_NaN());
    }

    LogarithmicVolumeLaw data;
  };
} // namespace springfit

#endif
