#ifndef springfit_fit_cell_gelder_h
#define springfit_fit_cell_gelder_h

#include <springfit/core/cell_kind.h>
#include <springfit/fit/cell_material.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * The springs of A. Van Gelder, Approximate simulation of elastic membranes
   * by triangulated spring meshes, Journal of Graphics Tools 3 (1998) 21-42:
   * k = E h A / |c|^2 for the edge c of a triangle of the area A, k = E V /
   * |c|^2 for a tetrahedron of the volume V. Poisson's ratio does not enter.
   *
   * @param points dim x n_vertices of a triangle or tetrahedron, m
   * @return one k per spring of node_pairs(), N/m
   */
  Eigen::VectorXd
  fit_gelder(const Eigen::MatrixXd &points,
             CellKind kind,
             const IsotropicMaterial &material);

  /** Of a cell: these springs alone. */
  FittedCell
  fit_gelder(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
