#ifndef springfit_springs_area_h
#define springfit_springs_area_h

#include <springfit/core/cell_kind.h>

#include <Eigen/Core>

namespace springfit
{
  // The coordinate of an area spring: the area (m^2, never negative) of a
  // triangle or quadrilateral in space, of the P1 or Q1 mapping of its vertices
  // in deal.II's numbering. That of a warped quadrilateral is integrated by
  // Gauss' quadrature with 2 x 2 points, which does not depend on where the
  // numbering begins; that of a plane convex one is exact. The area of a
  // plane cell of a mesh in 2-d is its volume (volume.h).
  //
  // @p points 3 x n_vertices, m. Gradients have 3 * n_vertices entries, row
  // 3 * v + d for component d of vertex v. The area has no derivatives where
  // the surface has no normal: in a triangle whose vertices are on a line.

  double
  area(const Eigen::MatrixXd &points, CellKind kind);

  /** m */
  Eigen::VectorXd
  area_gradient(const Eigen::MatrixXd &points, CellKind kind);

  Eigen::MatrixXd
  area_hessian(const Eigen::MatrixXd &points, CellKind kind);
} // namespace springfit

#endif
