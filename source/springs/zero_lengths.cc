#include <springfit/springs/pair_kind.h>
#include <springfit/springs/zero_lengths.h>

namespace springfit
{
  namespace
  {
    struct ZeroLength
    {
      static constexpr bool is_hookean    = true;
      static constexpr bool has_no_length = true;

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
