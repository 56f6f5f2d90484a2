#ifndef springfit_springs_volume_law_h
#define springfit_springs_volume_law_h

#include <springfit/core/words.h>

namespace springfit
{
  /**
   * The energy of volumes under pressure; see volumes.h. Both laws have the
   * same pressure and the same tangent at rest.
   */
  enum class VolumeLaw
  {
    /** Of the distance from a rest volume: finite for every volume. */
    quadratic,

    /** Of the logarithm of the volume: infinite for none. */
    logarithmic
  };

  const WordTable<VolumeLaw> &
  volume_law_words();
} // namespace springfit

#endif
