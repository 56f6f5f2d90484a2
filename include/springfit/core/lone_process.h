#ifndef springfit_core_lone_process_h
#define springfit_core_lone_process_h

namespace springfit
{
  /**
   * Tell Open MPI, before it begins, that a process which no mpirun has started
   * is the only one: it then needs no daemon, whose start takes a third of a
   * second, and no folder in /tmp, which runs that begin and end at the same
   * moment take away from each other (Open MPI 4.1 then refuses to begin). What
   * the environment says already is kept.
   */
  void
  prepare_for_lone_process();
} // namespace springfit

#endif
