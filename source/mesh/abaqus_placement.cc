#include <springfit/mesh/abaqus_placement.h>

#include <cmath>

namespace springfit
{
  namespace
  {
    MeshPoint
    difference(const MeshPoint &a, const MeshPoint &b)
    {
      return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
    }

    MeshPoint
    cross(const MeshPoint &a, const MeshPoint &b)
    {
      return {{a[1] * b[2] - a[2] * b[1],
               a[2] * b[0] - a[0] * b[2],
               a[0] * b[1] - a[1] * b[0]}};
    }

    MeshPoint
    unit(const MeshPoint &a, const TextPlace &place)
    {
      const double length = std::hypot(a[0], a[1], a[2]);
      if (!(length > 0.))
        throw text_error(place, "its points do not determine an axis");
      return {{a[0] / length, a[1] / length, a[2] / length}};
    }

    MeshPoint
    point_in(const std::vector<double> &values, const std::size_t first)
    {
      MeshPoint point{};
      for (std::size_t d = 0; d < 3 && first + d < values.size(); ++d)
        point[d] = values[first + d];
      return point;
    }

    // Rodrigues' formula.
    MeshPoint
    turned(const MeshPoint &x, const MeshPoint &axis, const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      const double part =
        (1. - c) * (axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2]);
      const MeshPoint across = cross(axis, x);
      MeshPoint result;
      for (unsigned int d = 0; d < 3; ++d)
        result[d] = c * x[d] + s * across[d] + part * axis[d];
      return result;
    }

    double
    radians(const double degrees)
    {
      return degrees * std::acos(-1.) / 180.;
    }
  } // namespace


  MeshPoint
  placed(const AbaqusPlacement &placement, const MeshPoint &point)
  {
    MeshPoint result = placement.origin;
    for (unsigned int axis = 0; axis < 3; ++axis)
      for (unsigned int d = 0; d < 3; ++d)
        result[d] += placement.axes[axis][d] * point[axis];
    return result;
  }


  MeshPoint
  between(const MeshPoint &a, const MeshPoint &b, const double t)
  {
    return {{a[0] + t * (b[0] - a[0]),
             a[1] + t * (b[1] - a[1]),
             a[2] + t * (b[2] - a[2])}};
  }


  MeshPoint
  from_cylindrical(const MeshPoint &point)
  {
    const double angle = radians(point[1]);
    return {{point[0] * std::cos(angle), point[0] * std::sin(angle), point[2]}};
  }


  AbaqusPlacement
  coordinate_system(const std::vector<double> &values, const TextPlace &place)
  {
    AbaqusPlacement system;
    if (values.size() > 9)
      throw text_error(place, "a system has more than three points");
    system.origin = point_in(values, 0);
    if (values.size() <= 3)
      return system;

    MeshPoint x = difference(point_in(values, 3), system.origin);
    if (values.size() <= 6)
      {
        if (x[2] != 0.)
          throw text_error(place,
                           "a system of two points has its second one at "
                           "another z than the first",
                           "Give a third point, in its plane of x and y.");
        system.axes[0] = unit(x, place);
        system.axes[1] = cross(system.axes[2], system.axes[0]);
        return system;
      }
    system.axes[0] = unit(x, place);
    system.axes[2] =
      unit(cross(x, difference(point_in(values, 6), system.origin)), place);
    system.axes[1] = cross(system.axes[2], system.axes[0]);
    return system;
  }


  AbaqusPlacement
  instance_placement(const std::vector<std::vector<double>> &lines,
                     const TextPlace &place)
  {
    AbaqusPlacement placement;
    if (lines.empty())
      return placement;
    if (lines.size() > 2 || lines[0].size() > 3 ||
        (lines.size() == 2 && lines[1].size() != 7))
      throw text_error(place,
                       "an instance has other lines than its translation (3 "
                       "numbers) and its rotation (7 numbers)");
    placement.origin = point_in(lines[0], 0);
    if (lines.size() < 2)
      return placement;

    const MeshPoint a    = point_in(lines[1], 0);
    const MeshPoint axis = unit(difference(point_in(lines[1], 3), a), place);
    const double angle   = radians(lines[1][6]);
    for (MeshPoint &own : placement.axes)
      own = turned(own, axis, angle);
    const MeshPoint from_axis =
      turned(difference(placement.origin, a), axis, angle);
    for (unsigned int d = 0; d < 3; ++d)
      placement.origin[d] = a[d] + from_axis[d];
    return placement;
  }
} // namespace springfit
