#ifndef springfit_fit_methods_h
#define springfit_fit_methods_h

#include <springfit/core/cell_kind.h>
#include <springfit/core/words.h>
#include <springfit/fit/cell_material.h>
#include <springfit/fit/enrichment.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** A fit; see the header of its name. */
  enum class Method
  {
    block,
    frobenius,
    spectral,
    consistent,
    compliance,
    stable_neo_hookean,
    gelder,
    lloyd,
    baudet,
    delingette,
    golec
  };

  const WordTable<Method> &
  method_words();

  /** The cells that a fit is for. */
  const std::vector<CellKind> &
  cells_of(Method method);

  /** The enrichments that a fit has. */
  const std::vector<Enrichment> &
  enrichments_of(Method method);

  /** Whether a fit can suit deformed states of a cell, see several_states.h. */
  bool
  has_states(Method method, Enrichment enrichment, CellKind kind);

  /**
   * Whether a fit has formulas of its own, to be taken as they are:
   * FitOptions::nonnegative does not change them.
   */
  bool
  has_formulas(Method method);

  /**
   * Whether a fit misses nothing of the finite element that it could have: the
   * cell is as stable as that, negative springs or not.
   */
  bool
  is_finite_element(Method method);

  // What files and tables call a fit and an enrichment: their words joined by
  // underscores.

  std::string
  name_of(Method method);

  std::string
  name_of(Enrichment enrichment);

  /** Of both: the fit, and behind it the enrichment unless that is none. */
  std::string
  name_of(const std::string &fit, const std::string &enrichment);

  /**
   * The assumptions of a published fit that a cell does not meet, as parts of
   * a sentence: "squares". The fit can be made all the same.
   */
  std::vector<std::string>
  unmet_assumptions(Method method,
                    const Eigen::MatrixXd &points,
                    CellKind kind,
                    const IsotropicMaterial &material);
} // namespace springfit

#endif
