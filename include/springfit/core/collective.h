#ifndef springfit_core_collective_h
#define springfit_core_collective_h

#include <mpi.h>

#include <functional>

namespace springfit
{
  /**
   * Run @p work on every rank. When it throws on any rank, the error of the
   * lowest such rank (InputError or RunError; any other exception becomes a
   * RunError) is thrown on every rank, so that all of them stop alike and the
   * user sees one message. @p work must not communicate.
   */
  void
  run_collectively(MPI_Comm communicator, const std::function<void()> &work);

  /**
   * Whether every rank calls this within @p seconds: how a rank that failed
   * finds out whether the others failed alike, or wait for it in vain.
   */
  bool
  all_ranks_arrive(MPI_Comm communicator, double seconds);

  /** run_collectively() for work that only the first rank does. */
  void
  run_on_root(MPI_Comm communicator, const std::function<void()> &work);
} // namespace springfit

#endif
