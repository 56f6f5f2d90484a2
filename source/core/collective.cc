#include <springfit/core/collective.h>
#include <springfit/core/error.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <utility>

namespace springfit
{
  namespace
  {
    enum class Outcome : int
    {
      done,
      input_error,
      run_error
    };

    std::pair<int, std::string>
    attempt(const std::function<void()> &work)
    {
      try
        {
          work();
          return {static_cast<int>(Outcome::done), ""};
        }
      catch (const InputError &error)
        {
          return {static_cast<int>(Outcome::input_error), error.what()};
        }
      catch (const std::exception &error)
        {
          return {static_cast<int>(Outcome::run_error), error.what()};
        }
    }
  } // namespace

  void
  run_collectively(const MPI_Comm               communicator,
                   const std::function<void()> &work)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      return work();

    const auto outcomes =
      dealii::Utilities::MPI::all_gather(communicator, attempt(work));
    for (const auto &[outcome, message] : outcomes)
      {
        if (outcome == static_cast<int>(Outcome::input_error))
          throw InputError(message);
        if (outcome == static_cast<int>(Outcome::run_error))
          throw RunError(message);
      }
  }

  void
  run_on_root(const MPI_Comm               communicator,
              const std::function<void()> &work)
  {
    run_collectively(communicator, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        work();
    });
  }
} // namespace springfit
