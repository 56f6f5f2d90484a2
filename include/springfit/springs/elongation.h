#ifndef springfit_springs_elongation_h
#define springfit_springs_elongation_h

#include <springfit/springs/length.h>
#include <springfit/springs/spring_law.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /** The elongation q of a spring and its derivatives. */
  template <int dim>
  struct Elongation
  {
    double value; // m

    // with respect to (x_i, x_j)
    Vector<2 * dim> gradient;
    Tensor<2 * dim> hessian; // 1/m
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
    if (law == SpringLaw::biquadratic)
      {
        const double L        = rest_length;
        const Vector<dim> g   = d / L;
        const Tensor<dim> h   = Tensor<dim>::Identity() / L;
        Elongation<dim> found = {(d.squaredNorm() - L * L) / (2. * L), {}, {}};
        found.gradient << -g, g;
        found.hessian << h, -h, -h, h;
        return found;
      }
    if (!(length<dim>(d) > 1e-12 * rest_length))
      return {};
    return Elongation<dim>{length<dim>(d) - rest_length,
                           length_gradient<dim>(d),
                           length_hessian<dim>(d)};
  }
} // namespace springfit

#endif
