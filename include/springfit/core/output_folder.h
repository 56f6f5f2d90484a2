#ifndef springfit_core_output_folder_h
#define springfit_core_output_folder_h

#include <filesystem>
#include <functional>
#include <string>

namespace springfit
{
  /**
   * The folder of a run's files, which holds either all files of an earlier
   * run or all files of this one. A run writes into a draft, a folder beside
   * it, and publish() exchanges the two by a single rename. A run that is
   * killed leaves the earlier files and a draft, which the next one removes.
   *
   * Where a folder cannot be renamed (a mount point, the working directory,
   * a file system that cannot exchange) the draft is inside it, under the name
   * .springfit-part. Publishing renames that to .springfit-new and then moves
   * file by file; as long as .springfit-new is there the folder is not whole,
   * and the next run first finishes the moving.
   *
   * Two runs cannot hold the same folder.
   */
  class OutputFolder
  {
  public:
    /** Whether a run writes results of this name, such as fit.csv. */
    using IsResult = std::function<bool(const std::string &name)>;

    /**
     * Create the folder if need be, lock it, tidy up after a killed run, and
     * begin an empty draft.
     *
     * @throws EntryError (of the entry "Output directory") when the folder
     * cannot be created or written, when another run holds it, and when
     * something that is no regular file bears the name of one of ours.
     */
    OutputFolder(const std::filesystem::path &folder,
                 const IsResult &is_result);

    /** Removes a draft that was not published. */
    ~OutputFolder();

    OutputFolder(const OutputFolder &) = delete;
    OutputFolder &
    operator=(const OutputFolder &) = delete;

    /** Where to write this run's files: after publish() the folder itself. */
    const std::filesystem::path &
    draft() const;

    bool
    is_published() const;

    /** False on file systems without locks. */
    bool
    is_locked() const;

    /** Whether an earlier run left results, and not its record alone. */
    bool
    holds_results() const;

    /** Remove from the draft what is not the record of the run. */
    void
    keep_record_only() const;

    /**
     * Put the draft in the place of the earlier run's files. All other files
     * and folders in there stay. A folder without a used.prm is one of the
     * user's own, in which nothing is an earlier run's.
     *
     * @throws RunError when that is not possible; the earlier files are then
     * in place.
     */
    void
    publish();

  private:
    /** A lock on a folder, which follows it when it is renamed. */
    class Lock
    {
    public:
      Lock() = default;
      ~Lock();

      Lock(const Lock &) = delete;
      Lock &
      operator=(const Lock &) = delete;

      enum class State
      {
        taken,
        held_by_another,
        unknown_here
      };

      State
      take(const std::filesystem::path &folder);

    private:
      int descriptor_ = -1;
    };

    void
    lock();

    void
    check_names() const;

    void
    begin_draft();

    bool
    is_ours(const std::string &name) const;

    bool
    is_of_earlier_run(const std::filesystem::path &file) const;

    void
    link_others() const;

    void
    list_stale_files() const;

    void
    tidy_beside() const;

    void
    finish_moving() const;

    const std::filesystem::path named_, folder_;
    const IsResult is_result_;
    const std::filesystem::path beside_, inside_, moving_;
    std::filesystem::path draft_;
    Lock lock_, draft_lock_;
    bool is_locked_ = false, is_published_ = false;
  };
} // namespace springfit

#endif
