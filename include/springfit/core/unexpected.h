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

  /**
   * From now on say in one line what happens where no exception can be caught:
   * a library throws in one of its threads, crashes, or ends the program. The
   * status is 1 then, and no stack trace is written. To be called when MPI,
   * which has handlers of its own, has begun.
   */
  void
  report_unexpected_ends();

  /** The program ends as it is meant to: the last call of main(). */
  void
  expect_end();

  /**
   * Check, before MPI begins, what it does not survive: that there is a working
   * directory, and memory for MPI itself under the limit of this process
   * (`ulimit -v`).
   *
   * @throws InputError when there is no working directory, RunError when there
   * is too little memory.
   */
  void
  check_surroundings();
} // namespace springfit

#endif
