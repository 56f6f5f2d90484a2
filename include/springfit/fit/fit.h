#ifndef springfit_fit_fit_h
#define springfit_fit_fit_h

#include <springfit/core/words.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /** What a fit makes small; see block.h, frobenius.h, spectral.h. */
  enum class Method
  {
    block,
    frobenius,
    spectral
  };

  /** What solves the spectral fit. */
  enum class Engine
  {
    ipopt,
    barrier
  };

  const WordTable<Method> &
  method_words();

  const WordTable<Engine> &
  engine_words();

  struct FitOptions
  {
    /** Keep every k >= 0. */
    bool nonnegative = false;

    Engine engine = Engine::ipopt;

    /**
     * The duality gap, relative to ||R||_2, that the caller is going to ask
     * of a spectral fit. The engines aim well below it.
     */
    double tolerance = 1e-6;
  };

  struct FitResult
  {
    /** One stiffness per spring, N/m */
    Eigen::VectorXd k;

    /** ||E(k)||_F / ||R||_F and ||E(k)||_2 / ||R||_2 */
    double frobenius_residual;
    double spectral_residual;

    /**
     * Of a spectral fit: how far at most ||E(k)||_2 is from the smallest
     * possible one, relative to ||R||_2. Certified by a dual bound, whatever
     * the engine did.
     */
    std::optional<double> duality_gap;

    unsigned int n_negative;
  };

  /**
   * Fit the springs of one cell. A large duality gap is reported, not thrown.
   *
   * @throws RunError when R is zero or not finite, or when the engine breaks
   * down without a result.
   */
  FitResult
  fit(const FitProblem &problem, Method method, const FitOptions &options);
} // namespace springfit

#endif
