#include <springfit/core/atomic_file.h>
#include <springfit/core/error.h>
#include <springfit/core/output_folder.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <set>
#include <system_error>
#include <vector>

namespace springfit
{
  namespace
  {
    namespace fs = std::filesystem;

    EntryError
    refusal(const std::string &what)
    {
      return EntryError("Output directory",
                        what,
                        "Choose a folder that can be written by 'Output "
                        "directory'.");
    }

    /** The real place of @p folder, which is created if need be. */
    fs::path
    created(const fs::path &folder)
    {
      std::error_code error;
      fs::create_directories(folder, error);
      if (error || !fs::is_directory(folder))
        throw refusal("the folder '" + folder.string() + "' cannot be created" +
                      (error ? ": " + error.message() : "") + '.');
      const fs::path real = fs::canonical(folder, error);
      if (error)
        throw refusal("the folder '" + folder.string() +
                      "' cannot be found: " + error.message() + '.');
      return real;
    }

    /** The entries of a folder at this moment. */
    std::vector<fs::directory_entry>
    entries(const fs::path &folder)
    {
      return {fs::directory_iterator(folder), fs::directory_iterator()};
    }

    /** Something of this name is there, be it a link to nowhere. */
    bool
    is_there(const fs::path &path)
    {
      return fs::symlink_status(path).type() != fs::file_type::not_found;
    }

    /** What says how a run was made; a folder with used.prm holds a run. */
    const std::set<std::string> record = {"log.txt",
                                          "original.prm",
                                          "used.prm"};
    const std::string mark_of_a_run    = "used.prm";

    /** In a folder whose files are being moved: what to remove before. */
    const std::string stale_files = "stale_files";

    /** @p name without the ending of a file that is being written. */
    std::string
    without_part(const std::string &name)
    {
      const std::string ending = ".part";
      const bool has_it =
        name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
      return has_it ? name.substr(0, name.size() - ending.size()) : name;
    }

    /** Exchange two folders in one step; what the system says about it. */
    std::error_code
    exchange(const fs::path &a, const fs::path &b)
    {
      if (renameat2(
            AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0)
        return {};
      return {errno, std::generic_category()};
    }

    /**
     * Whether a folder can be exchanged for the draft beside it. Whoever
     * works in a folder must find it again.
     */
    bool
    can_be_exchanged(const fs::path &folder, const fs::path &draft)
    {
      std::error_code ignored;
      if (fs::equivalent(folder, fs::current_path(ignored), ignored))
        return false;
      // On an empty folder of the same kind, to see whether it can be done.
      const fs::path probe = draft.string() + "-probe";
      fs::create_directory(probe, ignored);
      struct stat inside, outside;
      const bool can = stat(folder.c_str(), &inside) == 0 &&
                       stat(draft.c_str(), &outside) == 0 &&
                       inside.st_dev == outside.st_dev &&
                       !exchange(draft, probe);
      fs::remove(probe, ignored);
      return can;
    }
  } // namespace

  OutputFolder::Lock::~Lock()
  {
    if (descriptor_ >= 0)
      close(descriptor_);
  }

  OutputFolder::Lock::State
  OutputFolder::Lock::take(const fs::path &folder)
  {
    while (true)
      {
        descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor_ < 0)
          return State::unknown_here;
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
          return errno == EWOULDBLOCK ? State::held_by_another
                                      : State::unknown_here;
        // Its last holder may have exchanged the folder in the meantime.
        struct stat locked, named;
        if (fstat(descriptor_, &locked) != 0 ||
            stat(folder.c_str(), &named) != 0)
          return State::unknown_here;
        if (locked.st_ino == named.st_ino && locked.st_dev == named.st_dev)
          return State::taken;
        close(descriptor_);
      }
  }

  OutputFolder::OutputFolder(const fs::path &folder, const IsResult &is_result)
    : named_(folder)
    , folder_(created(folder))
    , is_result_(is_result)
    , beside_(folder_.parent_path() /
              ("." + folder_.filename().string() + ".springfit-part"))
    , inside_(folder_ / ".springfit-part")
    , moving_(folder_ / ".springfit-new")
  {
    lock();
    try
      {
        finish_moving();
        fs::remove_all(inside_);
        tidy_beside();
        check_names();
        begin_draft();
      }
    catch (const fs::filesystem_error &error)
      {
        throw refusal("the folder '" + named_.string() +
                      "' cannot be written: " + error.code().message() + '.');
      }
  }

  OutputFolder::~OutputFolder()
  {
    std::error_code ignored;
    if (!is_published_ && !draft_.empty())
      fs::remove_all(draft_, ignored);
  }

  const fs::path &
  OutputFolder::draft() const
  {
    return draft_;
  }

  bool
  OutputFolder::is_published() const
  {
    return is_published_;
  }

  bool
  OutputFolder::is_locked() const
  {
    return is_locked_;
  }

  void
  OutputFolder::lock()
  {
    const auto state = lock_.take(folder_);
    if (state == Lock::State::held_by_another)
      throw EntryError("Output directory",
                       "another run is writing into the folder '" +
                         named_.string() + "'.",
                       "Wait for its end, or choose another folder.");
    is_locked_ = state == Lock::State::taken;
  }

  void
  OutputFolder::check_names() const
  {
    for (const auto &entry : entries(folder_))
      if (is_ours(entry.path().filename().string()) && !entry.is_symlink() &&
          !entry.is_regular_file())
        throw EntryError("Output directory",
                         "'" + (named_ / entry.path().filename()).string() +
                           "' is in the way of a file of that name and is no "
                           "regular file.",
                         "Move it away, or choose another folder.");
  }

  void
  OutputFolder::begin_draft()
  {
    std::error_code error;
    fs::create_directory(beside_, error);
    if (!error && can_be_exchanged(folder_, beside_))
      {
        draft_ = beside_;
        // It will be the folder, and is not to be without a lock then.
        draft_lock_.take(draft_);
        fs::permissions(draft_, fs::status(folder_).permissions(), error);
        return;
      }
    fs::remove(beside_, error);
    fs::create_directory(inside_);
    draft_ = inside_;
  }

  bool
  OutputFolder::is_ours(const std::string &name) const
  {
    const std::string whole = without_part(name);
    return record.count(whole) > 0 || is_result_(whole);
  }

  bool
  OutputFolder::is_of_earlier_run(const fs::path &file) const
  {
    return fs::exists(folder_ / mark_of_a_run) &&
           is_ours(file.filename().string()) &&
           !fs::is_directory(fs::symlink_status(file));
  }

  bool
  OutputFolder::holds_results() const
  {
    for (const auto &entry : entries(folder_))
      if (is_of_earlier_run(entry.path()) &&
          is_result_(entry.path().filename().string()))
        return true;
    return false;
  }

  void
  OutputFolder::keep_record_only() const
  {
    for (const auto &entry : entries(draft_))
      if (record.count(entry.path().filename().string()) == 0)
        fs::remove_all(entry.path());
  }

  void
  OutputFolder::link_others() const
  {
    for (const auto &entry : entries(folder_))
      {
        const auto target = draft_ / entry.path().filename();
        if (is_of_earlier_run(entry.path()) || is_there(target))
          continue;
        if (entry.is_symlink())
          fs::copy_symlink(entry.path(), target);
        else if (!entry.is_directory()) // which cannot have two names
          {
            std::error_code error;
            fs::create_hard_link(entry.path(), target, error);
            if (error)
              fs::copy_file(entry.path(), target);
          }
      }
  }

  void
  OutputFolder::list_stale_files() const
  {
    write_file(draft_ / stale_files, [&](std::ostream &list) {
      for (const auto &entry : entries(folder_))
        if (const auto name = entry.path().filename();
            is_of_earlier_run(entry.path()) && !is_there(draft_ / name))
          list << name.string() << '\n';
    });
  }

  void
  OutputFolder::tidy_beside() const
  {
    if (!fs::is_directory(fs::symlink_status(beside_)))
      return;
    for (const auto &entry : entries(beside_))
      {
        const auto name = entry.path().filename();
        if (entry.is_directory() && !entry.is_symlink())
          {
            if (is_there(folder_ / name))
              throw refusal("a killed run left the user's folder '" +
                            entry.path().string() + "', and '" +
                            (named_ / name).string() + "' is there as well.");
            fs::rename(entry.path(), folder_ / name);
          }
        else if (is_ours(name.string()) || is_there(folder_ / name))
          fs::remove(entry.path());
        else
          fs::rename(entry.path(), folder_ / name);
      }
    fs::remove(beside_);
    fs::remove(beside_.string() + "-probe");
  }

  void
  OutputFolder::finish_moving() const
  {
    if (!is_there(moving_))
      return;
    std::ifstream list(moving_ / stale_files);
    for (std::string name; std::getline(list, name);)
      fs::remove(folder_ / name);
    for (const auto &entry : entries(moving_))
      if (const auto name = entry.path().filename(); name != stale_files)
        fs::rename(entry.path(), folder_ / name);
    fs::remove(moving_ / stale_files);
    fs::remove(moving_);
  }

  void
  OutputFolder::publish()
  {
    try
      {
        if (draft_ == beside_)
          {
            link_others();
            if (const auto error = exchange(draft_, folder_))
              throw fs::filesystem_error("", error);
            tidy_beside();
          }
        else
          {
            list_stale_files();
            fs::rename(inside_, moving_);
            finish_moving();
          }
      }
    catch (const fs::filesystem_error &error)
      {
        throw RunError("The results could not be put into the folder '" +
                         named_.string() + "': " + error.code().message() + '.',
                       "Choose another 'Output directory'.");
      }
    draft_        = folder_;
    is_published_ = true;
  }
} // namespace springfit
