#ifndef springfit_fit_cell_delingette_h
#define springfit_fit_cell_delingette_h

#include <springfit/fit/cell_material.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/rest_families.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  // H. Delingette, Triangular springs for modeling nonlinear membranes, IEEE
  // Transactions on Visualization and Computer Graphics 14 (2008) 329-341: the
  // quadratic springs of a triangle, for small elongations. With
  // lambda = E nu / (1 - nu^2), M = E (1 - nu) / (1 - nu^2), h the thickness,
  // A the area, L the length of an edge and alpha the angle opposite to it.
  // Springs and couplings together are the P1 stiffness of plane stress.
  //
  // @p points 2 x 3, m.

  /**
   * k = h L^2 (2 cot^2 alpha (lambda + M) + M) / (8 A)
   *
   * @return one k per spring of node_pairs(), N/m
   */
  Eigen::VectorXd
  fit_delingette(const Eigen::MatrixXd &points,
                 const IsotropicMaterial &material);

  /**
   * h L_a L_b (2 cot alpha_a cot alpha_b (lambda + M) - M) / (8 A) between the
   * edges a and b.
   */
  std::vector<LengthCoupling>
  delingette_couplings(const Eigen::MatrixXd &points,
                       const IsotropicMaterial &material);

  /** Of a cell: the springs, and the couplings if asked for. */
  FittedCell
  fit_delingette(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
