#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/unexpected.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <string>
#include <tuple>

namespace springfit
{
  namespace
  {
    enum class Outcome : int
    {
      done,
      entry_error,
      input_error,
      run_error
    };

    /** An outcome, the message, and the entry that it is about. */
    using Report = std::tuple<int, std::string, std::string>;

    Report
    report(const Outcome outcome,
           const std::string &message = "",
           const std::string &entry   = "")
    {
      return {static_cast<int>(outcome), message, entry};
    }

    Report
    attempt(const std::function<void()> &work)
    {
      try
        {
          work();
          return report(Outcome::done);
        }
      catch (const EntryError &error)
        {
          return report(Outcome::entry_error, error.what(), error.entry);
        }
      catch (const InputError &error)
        {
          return report(Outcome::input_error, error.what());
        }
      catch (const std::exception &error)
        {
          return report(Outcome::run_error, as_run_error(error).what());
        }
    }
  } // namespace

  void
  run_collectively(const MPI_Comm communicator,
                   const std::function<void()> &work)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      return work();

    const auto outcomes =
      dealii::Utilities::MPI::all_gather(communicator, attempt(work));
    for (const auto &[outcome, message, entry] : outcomes)
      switch (static_cast<Outcome>(outcome))
        {
          case Outcome::done:
            break;
          case Outcome::entry_error:
            throw EntryError(entry, message);
          case Outcome::input_error:
            throw InputError(message);
          case Outcome::run_error:
            throw RunError(message);
        }
  }

  bool
  all_ranks_arrive(const MPI_Comm communicator, const double seconds)
  {
    MPI_Request request;
    int arrived      = 0;
    const auto start = std::chrono::steady_clock::now();
    MPI_Ibarrier(communicator, &request);
    do
      MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    while (arrived == 0 && std::chrono::steady_clock::now() - start <
                             std::chrono::duration<double>(seconds));
    return arrived != 0;
  }

  void
  run_on_root(const MPI_Comm communicator, const std::function<void()> &work)
  {
    run_collectively(communicator, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        work();
    });
  }
} // namespace springfit
