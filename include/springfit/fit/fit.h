#ifndef springfit_fit_fit_h
#define springfit_fit_fit_h

#include <springfit/fit/cell_model.h>
#include <springfit/fit/methods.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <optional>

namespace springfit
{
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
     * S and S R S, see consistent.h.
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

    /**
     * Whether FitOptions::engine did not certify the fit, and the other one
     * solved it.
     */
    bool by_other_engine = false;
  };

  /**
   * Fit the springs of one cell, whose kind and enrichment must suit the
   * method, and without states unless has_states(). A large duality gap is
   * reported, not thrown.
   *
   * @throws RunError when R is zero or not finite, when the engine breaks
   * down without a result, when a volume is zero or an angle straight or
   * folded, when the constants are not finite or a hundred times too stiff, or
   * when a fit with FitOptions::nonnegative without formulas of its own is not
   * positive semidefinite all the same, or rounding hides whether it is.
   */
  FitResult
  fit(const FitProblem &problem,
      const Method &method,
      const FitOptions &options);

  /**
   * @throws RunError when the result's duality gap exceeds the tolerance.
   */
  void
  check_certificate(const FitResult &result, const FitOptions &options);
} // namespace springfit

#endif
