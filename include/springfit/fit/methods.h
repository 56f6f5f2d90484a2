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
   * Whether a fit has formulas of its own, to be taken as they are: options do
   * not change them.
   */
  bool
  is_published(Method method);

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
