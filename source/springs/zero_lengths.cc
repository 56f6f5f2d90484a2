#include <springfit/springs/pair_kind.h>
#include <springfit/springs/spring_law.h>
#include <springfit/springs/zero_lengths.h>

#include <string>

namespace springfit
{
  namespace
  {
    struct ZeroLength
    {
      static constexpr bool is_hookean    = true;
      static constexpr bool has_no_length = true;

      /** Hooke's, with L = 0. */
      static std::string
      word()
      {
        return word_of(spring_law_words(), SpringLaw::quadratic);
      }

      static double
      energy(const double k, double, const double s)
      {
        return 0.5 * k * s;
      }

      static double
      force(const double k, double, double)
      {
        return k;
      }

      static double
      curvature(double, double, double)
      {
        return 0.;
      }

      static bool
      is_smooth(double, double)
      {
        return true;
      }
    };
  } // namespace

  const SpringKind &
  zero_lengths(const int dim)
  {
    static const PairKind<2, ZeroLength> plane;
    static const PairKind<3, ZeroLength> space;
    if (dim == 2)
      return plane;
    return space;
  }
} // namespace springfit
