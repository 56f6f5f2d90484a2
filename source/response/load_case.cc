#include <springfit/response/load_case.h>

namespace springfit
{
  const WordTable<Load> &
  load_words()
  {
    static const WordTable<Load> table = {{Load::tension, "tension"},
                                          {Load::compression, "compression"},
                                          {Load::shear, "shear"},
                                          {Load::torsion, "torsion"}};
    return table;
  }
} // namespace springfit
