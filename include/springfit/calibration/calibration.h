#ifndef springfit_calibration_calibration_h
#define springfit_calibration_calibration_h

#include <springfit/calibration/cell_fits.h>
#include <springfit/calibration/distinct_cells.h>
#include <springfit/calibration/object_scope.h>
#include <springfit/core/session.h>
#include <springfit/fit/fit.h>
#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>
#include <springfit/reference/material.h>
#include <springfit/reference/material_law.h>
#include <springfit/springs/network.h>

#include <deal.II/base/parameter_acceptor.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** What a fit reached on one distinct cell. */
  struct CellFit
  {
    unsigned int cell; // active index of the first such cell of the mesh
    unsigned int multiplicity;
    FitResult result;
    double seconds;
  };

  /** A mesh turned into springs by one fit. */
  struct CalibratedNetwork
  {
    /**
     * What files and tables call it: <fit>, or <fit>_<enrichment> where it has
     * an enrichment.
     */
    std::string name;

    std::string fit;
    std::string enrichment;
    SpringNetwork network;

    /** What the unknowns of the fit were. */
    Scope scope;

    /** Of scope object a single one, which stands for the object. */
    std::vector<CellFit> cells;
    double seconds; // wall time of the calibration
  };


  /**
   * The section "Fit": for every distinct cell, the reference stiffness, the
   * springs' gradients and the fit; then the network of all cells.
   */
  template <int dim>
  class Calibration : public dealii::ParameterAcceptor
  {
  public:
    Calibration();

    /**
     * @throws EntryError when a method asked for is not for these cells, or has
     * no states on them.
     */
    void
    check_cells(CellKind kind) const;

    /** Whether fits shall suit other states than that at rest. */
    bool
    has_states() const;

    /**
     * @throws EntryError when there are states, and the material has the same
     * tangent in all of them.
     */
    void
    check_states(MaterialLaw law) const;

    /**
     * A network for each method and each enrichment asked for that the method
     * has. Warns where the assumptions of a published method do not hold.
     *
     * @param law of the finite elements in deformed states
     * @throws EntryError as check_cells() and check_states() do.
     * @throws RunError when a fit fails or its certified gap exceeds the
     * tolerance, with the cell, its place and its shape quality.
     */
    std::vector<CalibratedNetwork>
    calibrate(const Mesh<dim> &mesh,
              const Element<dim> &element,
              const MaterialTable &materials,
              const Eigen::MatrixXd &responses,
              MaterialLaw law,
              Session &session) const;

    /** A row of the tables. */
    struct Row
    {
      Method method;
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

    FitOptions
    options(const Row &row) const;

    Scope
    scope() const;

    /** Whether fits need the scene's responses to its loads. */
    bool
    needs_responses() const;

  private:
    void
    check() const;

    std::vector<Field>
    fields() const;

    /** Those that the fits tell apart. */
    DistinctCells
    distinct_cells(const Mesh<dim> &mesh) const;

    void
    warn_of_assumptions(const DistinctCells &cells,
                        const Mesh<dim> &mesh,
                        const MaterialTable &materials,
                        Session &session) const;

    // The network of one row and what the fit reached.

    void
    calibrate_cells(const DistinctCells &cells,
                    const Mesh<dim> &mesh,
                    const Element<dim> &element,
                    const MaterialTable &materials,
                    const ReferenceStates &states,
                    const Row &row,
                    CalibratedNetwork &network,
                    Session &session) const;

    void
    calibrate_object(const DistinctCells &cells,
                     const Mesh<dim> &mesh,
                     const Element<dim> &element,
                     const MaterialTable &materials,
                     const Eigen::MatrixXd &responses,
                     const Row &row,
                     CalibratedNetwork &network,
                     Session &session) const;

    std::string methods_word_     = "frobenius, spectral";
    std::string enrichments_word_ = "none";
    std::string norm_word_        = "frobenius";
    std::string engine_word_      = "ipopt";
    std::string fields_word_      = "responses";
    std::string law_word_         = "quadratic";
    std::string scope_word_       = "cell";
    Scope scope_                  = Scope::cell;
    std::string states_text_;
    FitOptions options_;
    SpringLaw law_ = SpringLaw::quadratic;
    std::vector<Eigen::MatrixXd> states_; // deformation gradients
  };
} // namespace springfit

#endif
