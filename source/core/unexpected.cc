#include <springfit/core/unexpected.h>

#include <deal.II/base/exceptions.h>

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>

namespace springfit
{
  namespace
  {
    /** @p text with single blanks, cut where nobody would read on. */
    std::string
    on_one_line(const std::string &text)
    {
      constexpr std::size_t longest = 300;

      std::istringstream words(text);
      std::string line;
      for (std::string word; words >> word;)
        line += (line.empty() ? "" : " ") + word;
      for (char &c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
          c = '?';
      return line.size() > longest ? line.substr(0, longest) + " ..." : line;
    }

    const char *const too_little_memory =
      "The memory of this machine does not suffice.";
    const char *const larger_cells = "Choose a larger 'Cell size'.";

    std::atomic<bool> end_is_expected = false;

    /** Without memory, and from a handler of signals. */
    void
    say(const char *text)
    {
      std::size_t length = 0;
      while (text[length] != '\0')
        ++length;
      // Nothing is left to do when this fails.
      [[maybe_unused]] const auto n = write(STDERR_FILENO, text, length);
    }

    // Other ranks are ended by mpirun, when one ends without saying goodbye to
    // MPI.
    [[noreturn]] void
    end_for_want_of_memory()
    {
      say("Error: ");
      say(too_little_memory);
      say(" ");
      say(larger_cells);
      say("\n");
      _exit(1);
    }

    [[noreturn]] void
    end_unexpectedly()
    {
      say("Error: The program ended unexpectedly, perhaps for want of memory. "
          "Choose a larger 'Cell size'; if that does not help, please report "
          "this with the parameter file.\n");
      _exit(1);
    }

    [[noreturn]] void
    on_terminate()
    {
      try
        {
          if (std::current_exception())
            throw;
        }
      catch (const std::bad_alloc &)
        {
          end_for_want_of_memory();
        }
      catch (...)
        {}
      end_unexpectedly();
    }

    void
    on_signal(int)
    {
      end_unexpectedly();
    }

    void
    on_exit()
    {
      if (!end_is_expected)
        end_unexpectedly();
    }
  } // namespace

  void
  report_unexpected_ends()
  {
    std::set_terminate(on_terminate);
    std::atexit(on_exit);

    // A handler of a stack overflow needs a stack of its own.
    static std::array<char, 1 << 16> memory;
    stack_t stack = {};
    stack.ss_sp   = memory.data();
    stack.ss_size = memory.size();
    sigaltstack(&stack, nullptr);
    struct sigaction action = {};
    action.sa_handler       = on_signal;
    action.sa_flags         = SA_ONSTACK;
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL})
      sigaction(signal, &action, nullptr);
    // Writing more than `ulimit -f` allows fails then, and says so.
    std::signal(SIGXFSZ, SIG_IGN);
  }

  void
  expect_end()
  {
    end_is_expected = true;
  }

  void
  check_surroundings()
  {
    std::error_code error;
    [[maybe_unused]] const auto here = std::filesystem::current_path(error);
    if (error)
      throw InputError("The working directory cannot be found: " +
                         error.message() + '.',
                       "Change into one that exists.");

    // What MPI asks for when it begins, measured.
    constexpr std::size_t needed = 150 << 20;
    rlimit limit                 = {};
    std::size_t pages            = 0;
    std::ifstream("/proc/self/statm") >> pages;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
        pages * sysconf(_SC_PAGESIZE) + needed > limit.rlim_cur)
      throw RunError("The memory that this process may use ('ulimit -v') does "
                     "not suffice.",
                     "Raise the limit.");
  }

  std::string
  message_of(const std::exception &error)
  {
    const auto *exception = dynamic_cast<const dealii::ExceptionBase *>(&error);
    if (exception == nullptr)
      return on_one_line(error.what());
    std::ostringstream info;
    exception->print_info(info);
    const std::string text = on_one_line(info.str());
    return text.empty() || text == "(none)" ? exception->get_exc_name() : text;
  }

  RunError
  as_run_error(const std::exception &error)
  {
    if (const auto *known = dynamic_cast<const RunError *>(&error))
      return *known;
    if (dynamic_cast<const std::bad_alloc *>(&error) != nullptr)
      return RunError(too_little_memory, larger_cells);
    return RunError("The run failed unexpectedly: " + message_of(error) + '.',
                    "Please report this with the parameter file.");
  }
} // namespace springfit
