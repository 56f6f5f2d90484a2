#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/session.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cerrno>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace springfit
{
  namespace
  {
    /** On the first rank; the error, if any, on all of them. */
    std::unique_ptr<OutputFolder>
    opened(const MPI_Comm communicator,
           const std::filesystem::path &output_directory,
           const OutputFolder::IsResult &is_result)
    {
      std::unique_ptr<OutputFolder> folder;
      run_on_root(communicator, [&]() {
        folder = std::make_unique<OutputFolder>(output_directory, is_result);
      });
      return folder;
    }
  } // namespace

  Session::Session(const MPI_Comm communicator,
                   const std::filesystem::path &output_directory,
                   const OutputFolder::IsResult &is_result)
    : communicator_(communicator)
    , output_directory_(output_directory)
    , folder_(opened(communicator, output_directory, is_result))
    , draft_name_(folder_ ? folder_->draft().string() : "")
    , log_stream_(log_file_, is_root())
    , timer_(log_stream_,
             dealii::TimerOutput::never,
             dealii::TimerOutput::wall_times)
  {
    run_on_root(communicator_, [&]() {
      log_file_.open(draft() / "log.txt");
      if (!log_file_)
        throw EntryError("Output directory",
                         "the folder '" + output_directory_.string() +
                           "' cannot be written: " + std::strerror(errno) + '.',
                         "Choose a folder that can be written by 'Output "
                         "directory'.");
    });
    if (is_root() && !folder_->is_locked())
      warn("The file system of '" + output_directory_.string() +
           "' has no locks: start no second run into this folder before the "
           "end of this one.");
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

  const std::filesystem::path &
  Session::draft() const
  {
    return folder_->draft();
  }

  bool
  Session::is_published() const
  {
    return dealii::Utilities::MPI::logical_or(folder_ &&
                                                folder_->is_published(),
                                              communicator_);
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
  Session::skip(const std::string &step, const std::string &why)
  {
    skipped_.push_back(step + ": " + why + '.');
  }

  void
  Session::say_at_the_end(const std::string &what_to_open)
  {
    last_line_ =
      "Results are in " + output_directory_.string() + ": " + what_to_open;
  }

  void
  Session::publish()
  {
    run_on_root(communicator_, [&]() {
      check_log();
      folder_->publish();
    });
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
    for (const auto &line : skipped_)
      log("Skipped - " + line);
    std::ostringstream text;
    text << "Peak memory of the largest rank: " << std::fixed
         << std::setprecision(1) << peak_kib / 1024. << " MiB";
    log(text.str());
    if (!last_line_.empty())
      log(last_line_);
    run_on_root(communicator_, [&]() {
      check_log();
      if (!folder_->is_published())
        folder_->publish();
      if (!last_line_.empty())
        std::cout << '\n' << last_line_ << std::endl;
    });
  }

  void
  Session::check_log()
  {
    log_file_.flush();
    if (!log_file_)
      throw RunError("The file '" + (output_directory_ / "log.txt").string() +
                       "' could not be written whole.",
                     "Free space on the disk.");
  }

  std::string
  Session::give_up(const std::string &message)
  {
    if (!folder_)
      return message;
    std::string text = message;
    // "out/fit.csv", also of a folder that is named "out/".
    const auto name = (output_directory_ / "").parent_path().string();
    for (std::size_t at = 0;
         (at = text.find(draft_name_, at)) != std::string::npos;
         at += name.size())
      text.replace(at, draft_name_.size(), name);
    log("The run ended with an error. " + text);
    if (folder_->is_published())
      return text;
    try
      {
        if (folder_->holds_results())
          std::cout << "The earlier results in " << output_directory_.string()
                    << " are unchanged." << std::endl;
        else
          {
            folder_->keep_record_only();
            folder_->publish();
          }
      }
    catch (const std::exception &)
      {
        // The error that ends the run is the one to report.
      }
    return text;
  }
} // namespace springfit
