#include <springfit/fit/enrichment.h>

namespace springfit
{
  const WordTable<Enrichment> &
  enrichment_words()
  {
    static const WordTable<Enrichment> table = {
      {Enrichment::none, "none"},
      {Enrichment::volume, "volume"},
      {Enrichment::point_volumes, "point volumes"},
      {Enrichment::angles, "angles"},
      {Enrichment::coupling, "coupling"}};
    return table;
  }
} // namespace springfit
