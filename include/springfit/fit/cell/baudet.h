#ifndef springfit_fit_cell_baudet_h
#define springfit_fit_cell_baudet_h

#include <springfit/core/cell_kind.h>
#include <springfit/fit/cell_material.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/rest_families.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  // V. Baudet, M. Beuve, F. Jaillet, B. Shariat and F. Zara, A new
  // mass-spring system integrating elasticity parameters in 2D, research
  // report LIRIS (2007); the same, Integrating tensile parameters in
  // hexahedral mass-spring system for simulation, WSCG (2009).
  //
  // @p points dim x n_vertices of a quadrilateral or hexahedron, m.

  /**
   * Rectangle with the sides l and h and the thickness t: diagonals
   * E t (l^2 + h^2) / (4 l h (1 + nu)), springs along l
   * E t (h^2 (3 nu + 2) - l^2) / (4 l h (1 + nu)), along h with l and h
   * exchanged; negative for elongated ones. Cube of side a: edges
   * E a (4 nu + 1) / (8 (1 + nu)), diagonals of the body
   * 3 E a / (8 (1 + nu)), none along those of the faces.
   *
   * As materials these networks have the shear modulus G, and Poisson's
   * ratio 1 / (3 nu + 2) or 1 / (4 nu + 3) in a tensile test.
   *
   * Of a quadrilateral that is no rectangle l and h are the mean lengths of
   * opposite edges; of a hexahedron that is no cube a is the cube root of the
   * volume.
   *
   * @return one k per spring of node_pairs(), N/m
   */
  Eigen::VectorXd
  fit_baudet(const Eigen::MatrixXd &points,
             CellKind kind,
             const IsotropicMaterial &material);

  /**
   * The lateral correction. Its authors add to the springs a stress across
   * the pull of c times the axial strain, c = E (3 nu - 1) / 2 (2-d) or
   * E (4 nu - 1) / 2 (3-d), which makes E and nu of a tensile test exact. Along
   * one known axis it is a force without an energy; no motion along the axis
   * answers it.
   *
   * Returned is its conservative form, the energy V c eps_x eps_y (3-d: and yz
   * and zx), with eps_x the mean elongation of the cell's edges along x
   * relative to their length: couplings between edges of different directions.
   * Also the strain across then acts along, so a tensile test gives exactly nu
   * and E (3 nu + 2) (1 - nu) / 2 in 2-d (1.015 E at nu = 0.3), and nu' = nu (4
   * nu + 3) / (4 nu^2 + 7 nu + 2) and E [2 nu + 1 - nu' nu (4 nu + 3)] / (1 +
   * nu) in 3-d (0.283 and 0.957 E).
   */
  std::vector<LengthCoupling>
  baudet_couplings(const Eigen::MatrixXd &points,
                   CellKind kind,
                   const IsotropicMaterial &material);

  /** The assumptions that a cell does not meet, as parts of a sentence. */
  std::vector<std::string>
  baudet_assumptions(const Eigen::MatrixXd &points,
                     CellKind kind,
                     const IsotropicMaterial &material);

  /** Of a cell: the springs, and the couplings if asked for. */
  FittedCell
  fit_baudet(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
