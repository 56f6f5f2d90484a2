#ifndef springfit_fit_enrichment_h
#define springfit_fit_enrichment_h

#include <springfit/core/words.h>

namespace springfit
{
  /** What a cell has besides springs between all pairs of its vertices. */
  enum class Enrichment
  {
    none,
    volume,        // a spring of its volume, in 2-d of its area
    point_volumes, // of the volume at each point of the FEM's quadrature
    angles,        // springs of the angles of its faces
    coupling       // terms between the lengths of two springs
  };

  const WordTable<Enrichment> &
  enrichment_words();
} // namespace springfit

#endif
