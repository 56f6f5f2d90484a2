#ifndef springfit_springs_elongation_h
#define springfit_springs_elongation_h

#include <springfit/springs/length.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * How the elongation of a spring follows from its length l and its rest
   * length L. The energy k q^2 / 2 is of the second or of the fourth degree in
   * the length; both laws have the same tangent at rest.
   */
  enum class SpringLaw
  {
    /** q = l - L: Hooke's spring. */
    quadratic,

    /**
     * q = (l^2 - L^2) / (2 L), which is d^T E d / L with Green's strain E and
     * d at rest: the full couplings of a P1 cell make it St. Venant-Kirchhoff's
     * material (Delingette, IEEE TVCG 14 (2008) 329, "biquadratic springs").
     */
    biquadratic
  };

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
