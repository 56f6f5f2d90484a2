#ifndef springfit_core_unexpected_h
#define springfit_core_unexpected_h

#include <springfit/core/error.h>

#include <exception>
#include <string>

namespace springfit
{
  /** What @p error says, on one line and without deal.II's stack trace. */
  std::string
  message_of(const std::exception &error);

  /**
   * An error that no part of the program has put into words: a failure of a
   * library or of the program itself, or too little memory.
   */
  RunError
  as_run_error(const std::exception &error);
} // namespace springfit

#endif
