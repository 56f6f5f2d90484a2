#ifndef springfit_springs_volumes_h
#define springfit_springs_volumes_h

#include <springfit/core/cell_kind.h>
#include <springfit/springs/family.h>

#include <Eigen/Core>

namespace springfit
{
  // Springs whose coordinate is the volume V of a cell (m^3), in 2-d its area
  // (m^2), of the P1 or Q1 mapping of its vertices; see volume.h. The nodes
  // n0, n1, ... are the vertices in deal.II's numbering, in which V > 0 at
  // rest.

  /**
   * The energy k (V - rest_volume)^2 / 2. Columns k (N/m^5, in 2-d N/m^3) and
   * rest_volume (m^3, in 2-d m^2). It is finite for cells turned inside out,
   * too.
   */
  const SpringKind &
  volumes(CellKind kind);

  /**
   * The V of a cell, to the last digit as the springs compute it: a spring that
   * shall be near rest wants it so.
   *
   * @param points dim x n_vertices, m
   */
  double
  spring_volume(const Eigen::MatrixXd &points, CellKind kind);

  /**
   * The logarithmic law: with J = V / rest_volume an energy of
   * rest_volume (- mu ln J + lambda (ln J)^2 / 2), infinite for J <= 0. Columns
   * mu and lambda (Pa, in 2-d times the thickness, N/m) and rest_volume (m^3,
   * m^2). It pushes at V = rest_volume, with the pressure mu.
   *
   * Together with zero_lengths() of mu it is the compressible neo-Hookean
   * material of Simo and Pister (1984), in 3-d and in plane strain.
   */
  const SpringKind &
  logarithmic_volumes(CellKind kind);

  /**
   * The same material in plane stress, per area: the stretch across the plane
   * that leaves no stress there is a function of J alone, see
   * core/plane_stress.h, and lambda that of plane stress.
   */
  const SpringKind &
  logarithmic_areas_in_plane_stress(CellKind kind);
} // namespace springfit

#endif
