#ifndef springfit_springs_by_table_h
#define springfit_springs_by_table_h

#include <springfit/springs/network.h>

namespace springfit
{
  /**
   * Families of one word and one law as one family, for tables: lengths and
   * zero lengths, which their rest lengths tell apart. Its kind is the first.
   */
  Families
  by_table(const Families &families);
} // namespace springfit

#endif
