#ifndef springfit_fit_cell_stable_neo_hookean_h
#define springfit_fit_cell_stable_neo_hookean_h

#include <springfit/fit/cell_model.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>
#include <springfit/springs/volume_law.h>

namespace springfit
{
  // The finite element itself, as springs that pull and volumes that push: B.
  // Smith, F. de Goes and T. Kim, Stable neo-Hookean flesh simulation, ACM TOG
  // 37 (2018), without its last term,
  //
  //     psi = mu / 2 (tr F^T F - dim) - mu (J - 1) + (lambda + mu) / 2 (J -
  //     1)^2
  //         = mu / 2 tr F^T F + (lambda + mu) / 2 (J - alpha)^2 + const,
  //     alpha = 1 + mu / (lambda + mu).
  //
  // The first term is that of springs of rest length zero between all pairs of
  // vertices, k_ab = - mu times the integral of grad N_a . grad N_b over the
  // cell at rest, because the shape functions sum to one. The second is that of
  // volumes V_g = dV_g J of stiffness (lambda + mu) / dV_g and rest value
  // alpha dV_g. With the logarithmic law the volumes have the energy dV_g (- mu
  // ln J + lambda / 2 (ln J)^2), and the whole is the compressible neo-Hookean
  // material of Simo and Pister (1984). In 2-d lambda is that of plane strain
  // or plane stress, and all constants are times the thickness.
  //
  // At rest the springs' tension and the volumes' pressure are in equilibrium,
  // and the tangent is that of linear elasticity with lambda and mu, for every
  // nu in (-1, 0.5). A spring opposite to an obtuse angle has k < 0.

  /**
   * With volumes at the points of the finite element's quadrature (simplices
   * have one): the tangent at rest is R, and the energy at any deformation that
   * of the finite element of the law.
   */
  CellModel
  fit_stable_neo_hookean_points(const FitProblem &problem, VolumeLaw law);

  /**
   * With the volume of the whole cell. On quadrilaterals and hexahedra this is
   * another element: the same under constant strain, and softer in the other
   * deformations, so that it does not lock as nu -> 0.5.
   */
  CellModel
  fit_stable_neo_hookean_volume(const FitProblem &problem, VolumeLaw law);

  /**
   * Of a cell: with point volumes or the volume, under the volume law asked
   * for.
   */
  FittedCell
  fit_stable_neo_hookean(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
