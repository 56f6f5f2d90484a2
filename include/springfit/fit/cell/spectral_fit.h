#ifndef springfit_fit_cell_spectral_fit_h
#define springfit_fit_cell_spectral_fit_h

#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

namespace springfit
{
  /** As make_spectral_problem(): what a spectral norm is to be made small of.
   */
  using SpectralProblemOf = SpectralProblem (*)(const Eigen::MatrixXd &points,
                                                const Eigen::MatrixXd &B,
                                                const Eigen::MatrixXd &R,
                                                Eigen::Index n_nonnegative,
                                                const Eigen::MatrixXd &least);

  /**
   * The forces of a cell that solve a spectral problem, by FitOptions::engine,
   * and their certified gap. Where that is more than FitOptions::tolerance the
   * other engine is tried. With all couplings a cell is exact, and nothing is
   * solved or certified.
   *
   * With FitOptions::nonnegative springs are >= 0, and the others such that in
   * no deformation the cell is softer than floor_of_eigenvalues(): a
   * semidefinite constraint of its own, where the solution without it does not
   * have that.
   *
   * @throws RunError when the engine breaks down without a result, or as
   * make_cell_terms().
   */
  FittedCell
  fit_with_certificate(const FitProblem &problem,
                       const FitOptions &options,
                       SpectralProblemOf spectral_problem);

  /**
   * Of a cell: the minimiser of ||E(k)||_2 (Natsupakpong and Cavusoglu 2010,
   * section 3), with its certificate. With all couplings the gap is what
   * rounding leaves.
   */
  FittedCell
  fit_spectral(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
