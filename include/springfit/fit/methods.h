#ifndef springfit_fit_methods_h
#define springfit_fit_methods_h

#include <springfit/core/cell_kind.h>
#include <springfit/core/words.h>
#include <springfit/fit/enrichment.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/object/object_problem.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** What only some fits know. */
  enum class Feature
  {
    /** FitProblem::states, with all couplings on simplices only */
    states,

    /** FitOptions::norm */
    norm,

    /** Displacement fields, in a fit of the whole object */
    fields,

    /**
     * Formulas of its own, to be taken as they are: FitOptions::nonnegative
     * does not change them.
     */
    formulas,

    /**
     * It misses nothing of the finite element that it could have: the cell is
     * as stable as that, negative springs or not.
     */
    finite_element
  };

  /** A fit: what users call it, what it is for, and its functions. */
  struct Method
  {
    std::string word;
    std::vector<CellKind> cells;
    std::vector<Enrichment> enrichments;
    std::vector<Feature> features;

    /**
     * The forces of one of its cells with one of its enrichments.
     *
     * @throws RunError as the header of its name says.
     */
    FittedCell (*fit)(const FitProblem &, const FitOptions &);

    /**
     * The constants of a whole object, given displacement fields and constants
     * to stay near to, see fit_displacements(). None for a fit of single cells.
     */
    Eigen::VectorXd (*fit_object)(const ObjectProblem &,
                                  const Eigen::MatrixXd &fields,
                                  const Eigen::VectorXd &prior) = nullptr;

    /**
     * The assumptions of a published fit that a cell does not meet, as parts
     * of a sentence: "squares". The fit can be made all the same. None for a
     * fit without.
     */
    std::vector<std::string> (*unmet_assumptions)(const Eigen::MatrixXd &points,
                                                  CellKind,
                                                  const IsotropicMaterial &) =
      nullptr;
  };

  /** All of them, in the order in which they are offered. */
  const WordTable<const Method *> &
  method_words();

  /** The one of this word, which there must be. */
  const Method &
  method_named(const std::string &word);

  bool
  has(const Method &method, Feature feature);

  bool
  suits(const Method &method, CellKind kind);

  bool
  suits(const Method &method, Enrichment enrichment);

  /** Whether a fit can suit deformed states of a cell, see several_states.h. */
  bool
  has_states(const Method &method, Enrichment enrichment, CellKind kind);

  /** Those that a cell does not meet; see Method::unmet_assumptions. */
  std::vector<std::string>
  unmet_assumptions(const Method &method,
                    const Eigen::MatrixXd &points,
                    CellKind kind,
                    const IsotropicMaterial &material);

  // What files and tables call a fit and an enrichment: their words joined by
  // underscores.

  std::string
  name_of(const Method &method);

  std::string
  name_of(Enrichment enrichment);

  /** Of both: the fit, and behind it the enrichment unless that is none. */
  std::string
  name_of(const std::string &fit, const std::string &enrichment);
} // namespace springfit

#endif
