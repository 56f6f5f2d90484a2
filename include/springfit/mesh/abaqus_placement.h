#ifndef springfit_mesh_abaqus_placement_h
#define springfit_mesh_abaqus_placement_h

#include <springfit/mesh/mesh_description.h>
#include <springfit/mesh/mesh_text.h>

#include <array>
#include <vector>

namespace springfit
{
  /** A rigid motion: point -> origin + sum of axes[d] * point[d]. */
  struct AbaqusPlacement
  {
    MeshPoint origin              = {{0., 0., 0.}};
    std::array<MeshPoint, 3> axes = {
      {{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};
  };

  /** The point after the motion. */
  MeshPoint
  placed(const AbaqusPlacement &placement, const MeshPoint &point);

  /** The point that lies the part @p t of the way from @p a to @p b. */
  MeshPoint
  between(const MeshPoint &a, const MeshPoint &b, double t);

  /** x, y, z of the radius, the angle in degrees, and z. */
  MeshPoint
  from_cylindrical(const MeshPoint &point);

  /**
   * What the numbers of *SYSTEM say: none for no motion; the origin; the origin
   * and a point on the local x-axis, which turn about z; or these and a point
   * in the local plane of x and y.
   *
   * @throws InputError with @p place when they do not determine a system.
   */
  AbaqusPlacement
  coordinate_system(const std::vector<double> &values, const TextPlace &place);

  /**
   * What the lines of *INSTANCE say: none; a translation; or this and after it
   * a rotation by two points of its axis and an angle in degrees.
   *
   * @throws InputError with @p place when they have other numbers of values, or
   * the two points are one.
   */
  AbaqusPlacement
  instance_placement(const std::vector<std::vector<double>> &lines,
                     const TextPlace &place);
} // namespace springfit

#endif
