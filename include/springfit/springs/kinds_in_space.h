#ifndef springfit_springs_kinds_in_space_h
#define springfit_springs_kinds_in_space_h

#include <springfit/springs/family.h>

namespace springfit
{
  /**
   * What springs in the plane are on a surface in space: the same law of the
   * same lengths, angles and areas, which do not change when a triangle is
   * moved from the plane into space.
   *
   * @throws std::logic_error of a kind that surfaces of triangles do not have.
   */
  const SpringKind &
  in_space(const SpringKind &kind);

  /** A family of a plane cell, with its constants, as one of a surface. */
  Family
  in_space(const Family &family);
} // namespace springfit

#endif
