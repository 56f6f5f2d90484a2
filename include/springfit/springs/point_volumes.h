#ifndef springfit_springs_point_volumes_h
#define springfit_springs_point_volumes_h

#include <springfit/core/cell_kind.h>
#include <springfit/springs/family.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  // Volumes at the points of Gauss' quadrature with two points per direction of
  // a quadrilateral (4) or hexahedron (8): V_g = w_g det (dx / dxi)(xi_g), in
  // m^2 or m^3, with weights w_g that sum to 1. Their sum is the volume of the
  // cell. Points are numbered like the vertices next to them, and the columns
  // hold a number for each of them. Laws and columns are those of volumes.h.

  const SpringKind &
  point_volumes(CellKind kind);

  /**
   * The V_g of a cell, to the last digit as the springs compute them.
   *
   * @param points dim x n_vertices, m
   */
  std::vector<double>
  spring_point_volumes(const Eigen::MatrixXd &points, CellKind kind);

  const SpringKind &
  logarithmic_point_volumes(CellKind kind);

  const SpringKind &
  logarithmic_point_areas_in_plane_stress(CellKind kind);
} // namespace springfit

#endif
