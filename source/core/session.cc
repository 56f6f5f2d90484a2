#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/session.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cerrno>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace springfit
{
  Session::Session(const MPI_Comm communicator,
                   const std::filesystem::path &output_directory)
    : communicator_(communicator)
    , output_directory_(output_directory)
    , log_stream_(log_file_, is_root())
    , timer_(log_stream_,
             dealii::TimerOutput::never,
             dealii::TimerOutput::wall_times)
  {
    run_on_root(communicator_, [&]() {
      const std::string mend =
        "Choose a folder that can be written by 'Output directory'.";
      std::error_code error;
      std::filesystem::create_directories(output_directory_, error);
      if (error || !std::filesystem::is_directory(output_directory_))
        throw EntryError("Output directory",
                         "the folder '" + output_directory_.string() +
                           "' cannot be created" +
                           (error ? ": " + error.message() : "") + '.',
                         mend);
      log_file_.open(output_directory_ / "log.txt");
      if (!log_file_)
        throw EntryError("Output directory",
                         "the folder '" + output_directory_.string() +
                           "' cannot be written: " + std::strerror(errno) + '.',
                         mend);
    });
  }

  MPI_Comm
  Session::communicator() const
  {
    return communicator_;
  }

  bool
  Session::is_root() const
  {
    return dealii::Utilities::MPI::this_mpi_process(communicator_) == 0;
  }

  const std::filesystem::path &
  Session::output_directory() const
  {
    return output_directory_;
  }

  void
  Session::print(const std::string &text)
  {
    if (is_root())
      std::cout << text << std::endl;
    log(text);
  }

  void
  Session::log(const std::string &text)
  {
    if (is_root())
      log_file_ << text << std::endl;
  }

  void
  Session::warn(const std::string &text)
  {
    print("Warning: " + text);
  }

  dealii::TimerOutput &
  Session::timer()
  {
    return timer_;
  }

  void
  Session::finish()
  {
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    const double peak_kib =
      dealii::Utilities::MPI::max(static_cast<double>(memory.VmHWM),
                                  communicator_);

    timer_.print_summary();
    std::ostringstream text;
    text << "Peak memory of the largest rank: " << std::fixed
         << std::setprecision(1) << peak_kib / 1024. << " MiB";
    log(text.str());
    run_on_root(communicator_, [&]() {
      log_file_.flush();
      if (!log_file_)
        throw RunError("The file '" + (output_directory_ / "log.txt").string() +
                         "' could not be written whole.",
                       "Free space on the disk.");
    });
  }
} // namespace springfit
