#ifndef springfit_fit_cell_consistent_h
#define springfit_fit_cell_consistent_h

#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

namespace springfit
{
  // The consistent fit: what a cell does under constant strain comes first.
  //
  // A mesh of small cells follows smooth displacements, and within a cell these
  // are affine up to the order of the cell's size. An error there is one of
  // the material and no refinement removes it; an error in the other,
  // "hourglass" modes counts with the square of the cell's size. The fits of
  // the whole matrix know no such order: a hexahedron has 12 hourglass modes
  // and 6 affine ones, and they spend most of their freedom on the former.
  //
  // Arguments as in block.h, with
  // @param points dim x n_nodes, m

  /**
   * A ladder of least squares on the error E = R - B diag(k) B^T, each rung
   * weighted against the next. With M the displacements of unit strains and H
   * an orthonormal basis of the hourglass modes:
   *
   *  10000  the bulk and the mean shear modulus: the two invariants of
   *         M^T E M under rotations. Least squares with too few terms shrink,
   *         and without this rung a network is too soft;
   *   1000  M^T E M, the energies of affine modes: the homogenised tensor;
   *    300  M^T E H, the forces of affine modes: the patch test. Of H only
   *         what quadratic displacements reach: between the others, which
   *         alternate from corner to corner, the forces of neighbours cancel;
   *      1  H^T E H, and M^T E H for all of H.
   *
   * The weights were found by trial on the square, the cube, the cylinder and
   * the specimen, regular and distorted, at nu = 0.3 and 0.45.
   *
   * A simplex has no hourglass modes and takes the first two rungs.
   *
   * With k >= 0 no rectangle or brick longer than sqrt(3) times its width can
   * be isotropic: its diagonals alone, which must be what resists shear, are
   * too stiff along it, and the springs along it vanish, which alone resist
   * hourglass modes: see without_mechanisms().
   */
  Eigen::VectorXd
  fit_consistent(const Eigen::MatrixXd &points,
                 const Eigen::MatrixXd &B,
                 const Eigen::MatrixXd &R,
                 Eigen::Index n_nonnegative);

  /**
   * The spectral fit of S E S, where S multiplies affine modes by 17 (the
   * ladder's 300 is its square) and leaves the others: one norm in which
   * affine modes come first. Not for a simplex, on which S is a factor.
   */
  SpectralProblem
  make_consistent_spectral_problem(const Eigen::MatrixXd &points,
                                   const Eigen::MatrixXd &B,
                                   const Eigen::MatrixXd &R,
                                   Eigen::Index n_nonnegative,
                                   const Eigen::MatrixXd &least = {});

  /**
   * Of a cell, see approximation.h; in FitOptions::norm.
   */
  FittedCell
  fit_consistent(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
