#ifndef springfit_core_incomplete_error_h
#define springfit_core_incomplete_error_h

#include <springfit/core/error.h>

#include <string>

namespace springfit
{
  /**
   * The run ends with status 1 because a part of its results is missing; what
   * it wrote is worth keeping all the same. Thrown on all ranks alike.
   */
  class IncompleteError : public RunError
  {
  public:
    using RunError::RunError;
  };
} // namespace springfit

#endif
