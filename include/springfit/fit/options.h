#ifndef springfit_fit_options_h
#define springfit_fit_options_h

#include <springfit/core/words.h>
#include <springfit/fit/enrichment.h>
#include <springfit/springs/volume_law.h>

namespace springfit
{
  /** What solves the spectral fit. */
  enum class Engine
  {
    ipopt,
    barrier
  };

  /** What the consistent fit minimises. */
  enum class Norm
  {
    frobenius,
    spectral
  };

  const WordTable<Engine> &
  engine_words();

  const WordTable<Norm> &
  norm_words();

  struct FitOptions
  {
    /** One of those that the fit has. */
    Enrichment enrichment = Enrichment::none;

    /**
     * Keep every spring from being negative. Volume springs, angles and
     * couplings are free as long as the cell stays positive semidefinite.
     */
    bool nonnegative = false;

    /** Of the volumes of a fit whose volumes are under pressure. */
    VolumeLaw volume_law = VolumeLaw::quadratic;

    /** Of a consistent fit of quadrilaterals and hexahedra. */
    Norm norm = Norm::frobenius;

    Engine engine = Engine::ipopt;

    /**
     * The duality gap, relative to ||R||_2, that the caller is going to ask
     * of a spectral fit. The engines aim well below it.
     */
    double tolerance = 1e-6;
  };
} // namespace springfit

#endif
