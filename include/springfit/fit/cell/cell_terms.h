#ifndef springfit_fit_cell_cell_terms_h
#define springfit_fit_cell_cell_terms_h

#include <springfit/fit/cell_model.h>
#include <springfit/fit/enrichment.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/network.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * The generalised springs that a fit may use, each by its tangent c g g^T at
   * rest: the cell's springs first, then those of an enrichment.
   */
  struct CellTerms
  {
    /** The terms in their order, with constants of one. */
    Families unit;

    /**
     * The first ones, which a fit with k >= 0 keeps from being negative.
     * Volumes and angles are free: they make up for a lambda < mu or > mu.
     */
    Eigen::Index n_springs;

    /**
     * (dim * n_nodes) x n_terms: the gradients of the coordinates. Those of
     * volumes and angles are divided by their norms, so that every c is in
     * N/m and of the order of the stiffness.
     */
    Eigen::MatrixXd gradients;

    /** What the gradients were divided by; 1 for a spring. */
    Eigen::VectorXd norms;
  };

  /**
   * The springs of a cell, with its volume spring or its angles.
   *
   * @param enrichment not coupling, whose tangents are not of this form: see
   * coupled_cell.h
   * @throws RunError when the volume is zero or an angle straight or folded.
   */
  CellTerms
  make_cell_terms(const FitProblem &problem, Enrichment enrichment);

  /**
   * The springs of a cell and its enrichment, at rest and with constants of
   * one.
   *
   * @throws std::logic_error as angles_at_rest() does.
   */
  Families
  unit_families(const FitProblem &problem, Enrichment enrichment);

  /** The forces of a cell from the constants of its terms, in N/m. */
  CellModel
  make_cell_model(const CellTerms &terms, const Eigen::VectorXd &constants);
} // namespace springfit

#endif
