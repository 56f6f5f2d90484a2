#ifndef springfit_fit_fit_h
#define springfit_fit_fit_h

#include <springfit/core/words.h>
#include <springfit/fit/cell_model.h>
#include <springfit/fit/enrichment.h>
#include <springfit/fit/methods.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/volume_law.h>

#include <optional>

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

  /** The lumped forces of a cell, and how near they are to R. */
  struct FitResult : CellModel
  {
    /**
     * ||E||_F / ||R||_F and ||E||_2 / ||R||_2 with E all that the springs,
     * couplings, angles and the volume spring miss.
     */
    double frobenius_residual;
    double spectral_residual;

    /**
     * Of a spectral fit: how far at most ||E(k)||_2 is from the smallest
     * possible one, relative to ||R||_2. Certified by a dual bound, whatever
     * the engine did. Of a consistent fit in the spectral norm: the same of S E
     * S and S R S, see consistent.h. Where FitOptions::nonnegative had to hold
     * volumes and angles too, smallest is meant with all of them >= 0.
     */
    std::optional<double> duality_gap;

    /**
     * The smallest eigenvalue of the cell's stiffness at rest on its
     * deformations, relative to ||R||_2: below zero it releases energy in
     * some deformation, at zero it is a mechanism. Not of a whole object.
     */
    std::optional<double> smallest_eigenvalue;

    /** Springs; couplings, angles and volume springs do not count. */
    unsigned int n_negative;

    /** Of a fit over several states, see residual_over_states(). */
    std::optional<double> states_residual = {};
  };

  /**
   * Fit the springs of one cell, which must be of a kind in cells_of() and with
   * an enrichment in enrichments_of() the method, and without states unless
   * has_states(). A large duality gap is reported, not thrown.
   *
   * @throws RunError when R is zero or not finite, when the engine breaks
   * down without a result, when a volume is zero or an angle straight or
   * folded, when the constants are not finite, or when a fit with
   * FitOptions::nonnegative without formulas of its own is not positive
   * semidefinite all the same.
   */
  FitResult
  fit(const FitProblem &problem, Method method, const FitOptions &options);

  /**
   * @throws RunError when the result's duality gap exceeds the tolerance.
   */
  void
  check_certificate(const FitResult &result, const FitOptions &options);
} // namespace springfit

#endif
