#ifndef springfit_core_isolated_h
#define springfit_core_isolated_h

#include <cstddef>
#include <functional>
#include <string>

namespace springfit
{
  /** What a piece of work may use. */
  struct WorkLimits
  {
    double seconds;    // on the wall clock
    std::size_t bytes; // of memory, beyond what the program has already
  };

  /** How a piece of work ended. */
  enum class WorkEnding
  {
    answered,
    crashed, // a signal, an exit, an exception that it did not catch
    too_slow,
    too_large
  };

  struct IsolatedWork
  {
    WorkEnding ending;

    /**
     * What the work returned. Of a crash: the string that it threw and did not
     * catch, or that a library threw where nobody can catch it; mostly empty.
     */
    std::string answer;
  };

  /**
   * Do @p work in a child process, so that a crash, a hang or a hunger for
   * memory in a library ends the child and not the program. The child has a
   * copy of all that the program knows, its answer is the string that @p work
   * returns; it says nothing on the screen and must not use MPI. Waits for the
   * child, and ends it when it has used up its time.
   *
   * @throws RunError when there can be no child.
   */
  IsolatedWork
  run_isolated(const WorkLimits &limits,
               const std::function<std::string()> &work);
} // namespace springfit

#endif
