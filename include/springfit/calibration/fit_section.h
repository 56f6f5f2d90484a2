#ifndef springfit_calibration_fit_section_h
#define springfit_calibration_fit_section_h

#include <springfit/calibration/object_scope.h>
#include <springfit/core/cell_kind.h>
#include <springfit/fit/fit.h>
#include <springfit/reference/material_law.h>
#include <springfit/springs/spring_law.h>

#include <deal.II/base/parameter_acceptor.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** The section "Fit": which fits are asked for, and of what. */
  template <int dim>
  class FitSection : public dealii::ParameterAcceptor
  {
  public:
    FitSection();

    /**
     * @throws EntryError when a method asked for is not for these cells, or has
     * no states on them.
     */
    void
    check_cells(CellKind kind) const;

    /**
     * @throws EntryError when there are states, and the material has the same
     * tangent in all of them.
     */
    void
    check_states(MaterialLaw law) const;

    /** A row of the tables. */
    struct Row
    {
      const Method *method;
      Enrichment enrichment;
    };

    /**
     * Each method with each enrichment asked for that it has.
     *
     * @throws EntryError when a word is not known, or a method has none of the
     * enrichments.
     */
    std::vector<Row>
    rows() const;

    /**
     * The same of a mesh of these cells: on simplices, which have one volume,
     * point volumes are the volume, and no row occurs twice.
     */
    std::vector<Row>
    rows(CellKind kind) const;

    FitOptions
    options(const Row &row) const;

    /** What the unknowns of the fits are. */
    Scope
    scope() const;

    /** Loads under which fits of the whole object get displacements right. */
    std::vector<Field>
    fields() const;

    /** Sentences on entries that were set and change nothing. */
    std::vector<std::string>
    unused_entries(CellKind kind) const;

    /** Whether a fit needs the scene's responses to its loads. */
    bool
    needs_responses(const Row &row) const;

    /** Whether any of them does. */
    bool
    needs_responses() const;

    /** Of springs and couplings away from rest. */
    SpringLaw
    spring_law() const;

    /** Whether fits shall suit other states than that at rest. */
    bool
    has_states() const;

    /** Their deformation gradients, dim x dim. */
    const std::vector<Eigen::MatrixXd> &
    states() const;

  private:
    void
    check() const;

    std::string methods_word_     = "frobenius, spectral";
    std::string enrichments_word_ = "none";
    std::string norm_word_        = "frobenius";
    std::string engine_word_      = "ipopt";
    std::string fields_word_      = "responses";
    std::string law_word_         = "quadratic";
    std::string volume_law_word_  = "quadratic";
    std::string scope_word_       = "cell";
    Scope scope_                  = Scope::cell;
    std::string states_text_;
    FitOptions options_;
    SpringLaw law_ = SpringLaw::quadratic;
    std::vector<Eigen::MatrixXd> states_; // deformation gradients
  };
} // namespace springfit

#endif
