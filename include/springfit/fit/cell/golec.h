#ifndef springfit_fit_cell_golec_h
#define springfit_fit_cell_golec_h

#include <springfit/fit/cell_material.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  // K. Golec, J.-F. Palierne, F. Zara, S. Nicolle and G. Damiand, Hybrid 3D
  // mass-spring system for simulation of isotropic materials with any
  // Poisson's ratio, The Visual Computer 36 (2020) 809-825: springs for the
  // part of the material that obeys Cauchy's relations (lambda = mu), and an
  // energy of the volume for the rest.
  //
  // @p points 3 x 4, m.

  /**
   * k = sqrt(2)/5 G l, which are the springs of Lloyd et al. at Poisson's
   * ratio 1/4; l is the edge of the regular tetrahedron of the same volume.
   *
   * @return one k per spring of node_pairs(), N/m
   */
  Eigen::VectorXd
  fit_golec(const Eigen::MatrixXd &points, const IsotropicMaterial &material);

  /**
   * The energy (lambda - mu) V0 (V / V0 - 1)^2 / 2 as that of a volume spring:
   * its stiffness (lambda - mu) / V0 in N/m^5, negative when Poisson's ratio is
   * below 1/4.
   */
  double
  golec_volume_stiffness(const Eigen::MatrixXd &points,
                         const IsotropicMaterial &material);

  /** The assumptions that a cell does not meet, as parts of a sentence. */
  std::vector<std::string>
  golec_assumptions(const Eigen::MatrixXd &points,
                    CellKind kind,
                    const IsotropicMaterial &material);

  /** Of a cell: springs and volume. */
  FittedCell
  fit_golec(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
