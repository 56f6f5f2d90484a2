#ifndef springfit_core_session_h
#define springfit_core_session_h

#include <springfit/core/output_folder.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <mpi.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

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
     * Creates the folder, and the log in the draft of its files.
     *
     * @param is_result says which names the results of a run have, so that
     * those of an earlier one make way; without it nothing is a result
     * @throws EntryError when the folder cannot be created or written, or when
     * another run holds it.
     */
    Session(
      MPI_Comm communicator,
      const std::filesystem::path &output_directory,
      const OutputFolder::IsResult &is_result = [](const std::string &) {
        return false;
      });

    MPI_Comm
    communicator() const;

    bool
    is_root() const;

    /** The folder as the user named it, for messages. */
    const std::filesystem::path &
    output_directory() const;

    /**
     * Where to write files: a draft until publish() or finish() put them into
     * the output folder, then that. On the first rank only.
     */
    const std::filesystem::path &
    draft() const;

    /** Whether they are there already. All ranks must call it. */
    bool
    is_published() const;

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
     * A step that the scene does not need, for the log below the table of
     * times: "Equilibria", "a calibration loads nothing".
     */
    void
    skip(const std::string &step, const std::string &why);

    /** What to open in the output folder: the last line of a run. */
    void
    say_at_the_end(const std::string &what_to_open);

    /**
     * Put the files of this run into the output folder, before its end: what is
     * written from now on is there at once. All ranks must call it.
     *
     * @throws RunError as finish() does.
     */
    void
    publish();

    /**
     * Write the table of times and the largest memory of any rank to the log,
     * put the files of this run into the output folder and say so. All ranks
     * must call it.
     *
     * @throws RunError when the log could not be written whole or the files
     * could not be put there; earlier ones are in place then.
     */
    void
    finish();

    /**
     * The run has failed with the error @p message: leave the results of an
     * earlier run as they are, with their record; where there are none, leave
     * the record of this run with its log. Does nothing after finish(). Does
     * not communicate, as other ranks may be elsewhere, and does not throw.
     *
     * @return @p message, which may name the draft, with the output folder in
     * its place
     */
    std::string
    give_up(const std::string &message);

  private:
    void
    check_log();

    const MPI_Comm communicator_;
    const std::filesystem::path output_directory_;
    const std::unique_ptr<OutputFolder> folder_; // of the first rank
    const std::string draft_name_;
    std::string last_line_;
    std::vector<std::string> skipped_;
    std::ofstream log_file_;
    dealii::ConditionalOStream log_stream_;
    dealii::TimerOutput timer_;
  };
} // namespace springfit

#endif
