#include <springfit/springs/lengths.h>
#include <springfit/springs/pair_kind.h>

#include <cmath>
#include <string>

namespace springfit
{
  namespace
  {
    /** q = l - L */
    struct Quadratic
    {
      static constexpr bool is_hookean    = true;
      static constexpr bool has_no_length = false;

      static std::string
      word()
      {
        return word_of(spring_law_words(), SpringLaw::quadratic);
      }

      static double
      energy(const double k, const double L, const double s)
      {
        const double q = std::sqrt(s) - L;
        return 0.5 * k * q * q;
      }

      static double
      force(const double k, const double L, const double s)
      {
        return k * (1. - L / std::sqrt(s));
      }

      static double
      curvature(const double k, const double L, const double s)
      {
        return k * L / (s * std::sqrt(s));
      }

      static bool
      is_smooth(const double L, const double s)
      {
        return s > 1e-24 * L * L;
      }
    };

    /** q = (l^2 - L^2) / (2 L) */
    struct Biquadratic
    {
      static constexpr bool is_hookean    = false;
      static constexpr bool has_no_length = false;

      static std::string
      word()
      {
        return word_of(spring_law_words(), SpringLaw::biquadratic);
      }

      static double
      energy(const double k, const double L, const double s)
      {
        const double q = (s - L * L) / (2. * L);
        return 0.5 * k * q * q;
      }

      static double
      force(const double k, const double L, const double s)
      {
        return k * (s - L * L) / (2. * L * L);
      }

      static double
      curvature(const double k, const double L, double)
      {
        return k / (L * L);
      }

      static bool
      is_smooth(double, double)
      {
        return true;
      }
    };

    template <int dim>
    const SpringKind &
    lengths(const SpringLaw law)
    {
      static const PairKind<dim, Quadratic> quadratic;
      static const PairKind<dim, Biquadratic> biquadratic;
      if (law == SpringLaw::biquadratic)
        return biquadratic;
      return quadratic;
    }
  } // namespace

  const SpringKind &
  lengths(const int dim, const SpringLaw law)
  {
    return dim == 2 ? lengths<2>(law) : lengths<3>(law);
  }
} // namespace springfit
