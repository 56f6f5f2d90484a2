#include <springfit/core/error.h>
#include <springfit/core/isolated.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <new>

namespace springfit
{
  namespace
  {
    // How the child ends; any other status is a crash.
    constexpr int status_of_answer    = 0;
    constexpr int status_of_too_large = 3;
    constexpr int status_of_exception = 4;

    // The first byte of an answer: without it, a child that calls exit(0) has
    // not answered.
    constexpr char mark = 'A';

    // The child's end of the pipe, for its last words.
    int last_words = -1;

    void
    limit_memory([[maybe_unused]] const std::size_t bytes)
    {
      // AddressSanitizer reserves terabytes.
#ifndef __SANITIZE_ADDRESS__
      std::size_t pages = 0;
      std::ifstream("/proc/self/statm") >> pages;
      const rlim_t limit = pages * sysconf(_SC_PAGESIZE) + bytes;
      rlimit now;
      getrlimit(RLIMIT_AS, &now);
      now.rlim_cur = std::min(limit, now.rlim_max);
      setrlimit(RLIMIT_AS, &now);
#endif
      const rlimit no_core = {0, 0};
      setrlimit(RLIMIT_CORE, &no_core);
    }

    // MPI's handlers of signals would write a stack trace.
    void
    be_silent()
    {
      for (const int signal :
           {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM})
        std::signal(signal, SIG_DFL);
      std::signal(SIGPIPE, SIG_IGN);
      const int nowhere = open("/dev/null", O_RDWR);
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        dup2(nowhere, stream);
    }

    bool
    write_all(const int file, const std::string &text)
    {
      for (std::size_t done = 0; done < text.size();)
        {
          const ssize_t n = write(file, text.data() + done, text.size() - done);
          if (n < 0 && errno != EINTR)
            return false;
          done += std::max<ssize_t>(n, 0);
        }
      return true;
    }

    // A string, as gmsh throws it, says what is wrong; other exceptions tell a
    // user nothing. gmsh throws in its threads, too, which ends the child here.
    [[noreturn]] void
    complain()
    {
      try
        {
          if (std::current_exception())
            throw;
        }
      catch (const std::string &complaint)
        {
          write_all(last_words, complaint);
        }
      catch (...)
        {}
      _exit(status_of_exception);
    }

    // _exit, because libraries that have read nonsense crash in their
    // destructors, too.
    [[noreturn]] void
    be_child(const int file,
             const WorkLimits &limits,
             const std::function<std::string()> &work)
    {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      be_silent();
      last_words = file;
      std::set_terminate(complain);
      limit_memory(limits.bytes);
      try
        {
          _exit(write_all(file, mark + work()) ? status_of_answer
                                               : status_of_exception);
        }
      catch (const std::bad_alloc &)
        {
          _exit(status_of_too_large);
        }
      catch (...)
        {
          complain();
        }
    }

    /** All that comes until the child closes its end; false out of time. */
    bool
    read_until_closed(const int file, const double seconds, std::string &text)
    {
      using Clock    = std::chrono::steady_clock;
      const auto end = Clock::now() + std::chrono::duration<double>(seconds);
      std::string part(1 << 16, '\0');
      while (true)
        {
          const double left =
            std::chrono::duration<double>(end - Clock::now()).count();
          if (left <= 0.)
            return false;
          pollfd events = {file, POLLIN, 0};
          if (poll(&events,
                   1,
                   static_cast<int>(std::min(left, 1.) * 1e3) + 1) <= 0)
            continue;
          const ssize_t n = read(file, part.data(), part.size());
          if (n == 0)
            return true;
          if (n > 0)
            text.append(part, 0, n);
        }
    }

    int
    wait_for(const pid_t child)
    {
      int status = 0;
      while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
      return status;
    }
  } // namespace


  IsolatedWork
  run_isolated(const WorkLimits &limits,
               const std::function<std::string()> &work)
  {
    int ends[2];
    const RunError failure("No child process can be started to read a file in.",
                           "End other programs, or free memory.");
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw failure;
    const pid_t child = fork();
    if (child == 0)
      {
        close(ends[0]);
        be_child(ends[1], limits, work);
      }
    close(ends[1]);
    if (child < 0)
      {
        close(ends[0]);
        throw failure;
      }

    std::string answer;
    const bool in_time = read_until_closed(ends[0], limits.seconds, answer);
    close(ends[0]);
    if (!in_time)
      kill(child, SIGKILL);
    const int status = wait_for(child);

    if (!in_time)
      return {WorkEnding::too_slow, ""};
    if (WIFEXITED(status) && WEXITSTATUS(status) == status_of_too_large)
      return {WorkEnding::too_large, ""};
    if (WIFEXITED(status) && WEXITSTATUS(status) == status_of_exception)
      return {WorkEnding::crashed, answer};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != status_of_answer ||
        answer.empty() || answer[0] != mark)
      return {WorkEnding::crashed, ""};
    return {WorkEnding::answered, answer.substr(1)};
  }
} // namespace springfit
