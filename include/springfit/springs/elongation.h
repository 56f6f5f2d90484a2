#ifndef springfit_springs_elongation_h
#define springfit_springs_elongation_h

#include <springfit/springs/length.h>
#include <springfit/springs/spring_law.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * The elongation q of a spring and its derivatives with respect to
   * (x_i, x_j), each computed when asked for: forces want no Hessian.
   */
  template <int dim>
  struct Elongation
  {
    SpringLaw law;
    double rest_length; // L, m
    Vector<dim> d;      // x_j - x_i, m

    /** m */
    double
    value() const
    {
      if (law == SpringLaw::biquadratic)
        return (d.squaredNorm() - rest_length * rest_length) /
               (2. * rest_length);
      return length<dim>(d) - rest_length;
    }

    Vector<2 * dim>
    gradient() const
    {
      if (law == SpringLaw::quadratic)
        return length_gradient<dim>(d);
      const Vector<dim> g = d / rest_length;
      Vector<2 * dim> gradient;
      gradient << -g, g;
      return gradient;
    }

    /** 1/m */
    Tensor<2 * dim>
    hessian() const
    {
      if (law == SpringLaw::quadratic)
        return length_hessian<dim>(d);
      const Tensor<dim> h = Tensor<dim>::Identity() / rest_length;
      Tensor<2 * dim> hessian;
      hessian << h, -h, -h, h;
      return hessian;
    }
  };

  /**
   * @param rest_length L > 0, m
   * @param d x_j - x_i, m
   * @return nothing for the quadratic law where the nodes coincide,
   * |d| <= 1e-12 L: it has no direction there.
   */
  template <int dim>
  std::optional<Elongation<dim>>
  elongation(const SpringLaw law,
             const double rest_length,
             const Vector<dim> &d)
  {
    if (law == SpringLaw::quadratic && !(length<dim>(d) > 1e-12 * rest_length))
      return {};
    return Elongation<dim>{law, rest_length, d};
  }
} // namespace springfit

#endif
