#ifndef springfit_fit_object_object_problem_h
#define springfit_fit_object_object_problem_h

#include <springfit/core/energy_term.h>

#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /**
   * A whole object all of whose terms are fitted at once: find constants c
   * such that sum_m c_m T_m resembles R. Terms are springs, couplings, volume
   * springs, whatever has a tangent at rest that is its constant times a
   * matrix. Degree of freedom dim * v + d is component d of node v; n of them.
   */
  struct ObjectProblem
  {
    /** dim x n_nodes, m */
    Eigen::MatrixXd nodes;

    /** R, n x n, N/m: the assembled stiffness, without supports */
    Eigen::SparseMatrix<double> stiffness;

    /**
     * T_m is the Hessian of terms[m]: the tangent at rest with a constant of
     * one. Energies and gradients are not used.
     */
    std::vector<EnergyTerm> terms;

    /** A flag per term: whether its constant must be >= 0. */
    std::vector<bool> nonnegative;
  };

  /** An entry of a term's tangent, by degrees of freedom of the object. */
  struct TangentEntry
  {
    Eigen::Index row;
    Eigen::Index column;
    double value;
  };

  /** All entries; those of a node that occurs twice are to be added. */
  std::vector<TangentEntry>
  tangent_entries(const EnergyTerm &term);

  /** K(c) = sum_m c_m T_m, n x n, N/m */
  Eigen::SparseMatrix<double>
  fitted_stiffness(const ObjectProblem &problem,
                   const Eigen::VectorXd &constants);
} // namespace springfit

#endif
