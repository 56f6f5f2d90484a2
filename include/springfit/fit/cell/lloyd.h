#ifndef springfit_fit_cell_lloyd_h
#define springfit_fit_cell_lloyd_h

#include <springfit/core/cell_kind.h>
#include <springfit/fit/cell_material.h>
#include <springfit/fit/fitted_cell.h>
#include <springfit/fit/options.h>
#include <springfit/fit/problem.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * The springs of B. A. Lloyd, G. Szekely and M. Harders, Identification of
   * spring parameters for deformable object simulation, IEEE Transactions on
   * Visualization and Computer Graphics 13 (2007) 1081-1094: triangle
   * sqrt(3)/4 E h; square 5/16 E h along the edges, 7/16 E h along the
   * diagonals; tetrahedron 2 sqrt(2)/25 E l with the edge l of the regular
   * tetrahedron of the same volume.
   *
   * They are derived for regular cells with Poisson's ratio 1/3 (2-d) or 1/4
   * (3-d). For any other cell the same constants are returned; see
   * lloyd_assumptions().
   *
   * @param points dim x n_vertices of a triangle, quadrilateral or
   * tetrahedron, m
   * @return one k per spring of node_pairs(), N/m
   */
  Eigen::VectorXd
  fit_lloyd(const Eigen::MatrixXd &points,
            CellKind kind,
            const IsotropicMaterial &material);

  /** The assumptions that a cell does not meet, as parts of a sentence. */
  std::vector<std::string>
  lloyd_assumptions(const Eigen::MatrixXd &points,
                    CellKind kind,
                    const IsotropicMaterial &material);

  /** Of a cell: these springs alone. */
  FittedCell
  fit_lloyd(const FitProblem &problem, const FitOptions &options);
} // namespace springfit

#endif
