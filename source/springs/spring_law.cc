#include <springfit/springs/spring_law.h>

namespace springfit
{
  const WordTable<SpringLaw> &
  spring_law_words()
  {
    static const WordTable<SpringLaw> table = {
      {SpringLaw::quadratic, "quadratic"},
      {SpringLaw::biquadratic, "biquadratic"}};
    return table;
  }
} // namespace springfit
