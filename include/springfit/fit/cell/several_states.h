#ifndef springfit_fit_cell_several_states_h
#define springfit_fit_cell_several_states_h

#include <springfit/fit/cell/cell_terms.h>
#include <springfit/fit/cell_model.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

namespace springfit
{
  // Fits that see a cell deformed too: the sum over its configurations x_p,
  // the one at rest and the problem's states, of ||R(x_p) - K(x_p)||_F^2
  // (Natsupakpong and Cavusoglu 2010, section 3), with the tangents R of the
  // reference and K = sum_m c_m H_m of the cell's forces. The Hessians H_m(x_p)
  // of the energies do not depend on the constants c_m, so that this is a
  // linear least squares problem in any state.

  /**
   * K(x), (dim * n_nodes)^2, N/m: the tangent of a cell's forces, stress
   * stiffness included, with the problem's spring law.
   *
   * @param displacement dim x n_nodes, m
   * @throws RunError when a term has no derivatives there: a length of zero, an
   * angle straight or folded.
   */
  Eigen::MatrixXd
  tangent(const FitProblem &problem,
          const CellModel &model,
          const Eigen::MatrixXd &displacement);

  /**
   * (sum_p ||R(x_p) - K(x_p)||_F^2 / sum_p ||R(x_p)||_F^2)^(1/2)
   *
   * @throws RunError as tangent() does.
   */
  double
  residual_over_states(const FitProblem &problem, const CellModel &model);

  /**
   * The minimiser of the sum over the constants of @p terms; without states
   * that of fit_frobenius().
   *
   * @param n_nonnegative how many of the constants, from the first on, must not
   * be negative
   * @throws RunError as tangent() does, or when the fit does not settle.
   */
  CellModel
  fit_over_states(const FitProblem &problem,
                  const CellTerms &terms,
                  Eigen::Index n_nonnegative);

  /**
   * The minimiser of the sum over the springs of a simplex and all couplings
   * between them, 6 numbers on a triangle and 21 on a tetrahedron. (Other
   * cells have more products of two lengths than tangents can tell apart.)
   *
   * With the biquadratic spring law and all couplings a simplex is St.
   * Venant-Kirchhoff's material in every state, and the fit to it is that at
   * rest, see coupled_cell.h.
   *
   * @param n_nonnegative as above; the springs come first
   * @throws RunError as above.
   */
  CellModel
  fit_coupled_over_states(const FitProblem &problem,
                          Eigen::Index n_nonnegative);

  /**
   * The forces of a cell that shall suit its states, the minimiser of one of
   * the sums above. With FitOptions::nonnegative it is moved towards a definite
   * one as approximate() does; with all couplings towards the one that is exact
   * at rest.
   *
   * @throws RunError as above.
   */
  FittedCell
  fit_states(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
