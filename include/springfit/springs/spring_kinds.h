#ifndef springfit_springs_spring_kinds_h
#define springfit_springs_spring_kinds_h

#include <springfit/springs/family.h>

#include <vector>

namespace springfit
{
  /**
   * Every kind of spring that there is, in every dimension and of every cell: a
   * number for each, which ranks can exchange.
   */
  const std::vector<const SpringKind *> &
  spring_kinds();

  /**
   * The position of a kind in spring_kinds().
   *
   * @throws std::logic_error when it is not there.
   */
  std::size_t
  number_of(const SpringKind &kind);
} // namespace springfit

#endif
