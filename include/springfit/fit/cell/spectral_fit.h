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
                                                Eigen::Index n_nonnegative);

  /**
   * The forces of a cell that solve a spectral problem, by FitOptions::engine,
   * and their certified gap. With all couplings a cell is exact, and nothing is
   * solved or certified.
   *
   * With FitOptions::nonnegative springs are >= 0. Where the cell then releases
   * energy in a deformation, or is softer in one than floor_of_eigenvalues(),
   * all constants are asked to be >= 0, and where that does not do, the springs
   * to be no softer than equal ones that are at the floor. The certificate is
   * that of the problem with these bounds.
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
