#ifndef springfit_core_session_h
#define springfit_core_session_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <mpi.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace springfit
{
  /**
   * One run: its ranks, its output folder, what it says on the screen and in
   * the log, and where its time goes. Only the first rank speaks and writes.
   */
  class Session
  {
  public:
    /**
     * Creates the folder and the log in it.
     *
     * @throws EntryError when the folder cannot be created or written.
     */
    Session(MPI_Comm communicator,
            const std::filesystem::path &output_directory);

    MPI_Comm
    communicator() const;

    bool
    is_root() const;

    const std::filesystem::path &
    output_directory() const;

    /** A line, or several, for the screen and the log. */
    void
    print(const std::string &text);

    /** A line for the log only. */
    void
    log(const std::string &text);

    /** A line that begins with "Warning:", for the screen and the log. */
    void
    warn(const std::string &text);

    /** The wall time of each step, for the log. */
    dealii::TimerOutput &
    timer();

    /**
     * Write the table of times and the largest memory of any rank to the log.
     *
     * @throws RunError when the log could not be written whole.
     */
    void
    finish();

  private:
    const MPI_Comm communicator_;
    const std::filesystem::path output_directory_;
    std::ofstream log_file_;
    dealii::ConditionalOStream log_stream_;
    dealii::TimerOutput timer_;
  };
} // namespace springfit

#endif
