#include <springfit/springs/volume_law.h>

namespace springfit
{
  const WordTable<VolumeLaw> &
  volume_law_words()
  {
    static const WordTable<VolumeLaw> table = {
      {VolumeLaw::quadratic, "quadratic"},
      {VolumeLaw::logarithmic, "logarithmic"}};
    return table;
  }
} // namespace springfit
