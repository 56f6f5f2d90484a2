#include <springfit/output/gnuplot.h>

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>

extern char **environ;

namespace springfit
{
  std::string
  draw(const std::filesystem::path &folder,
       const std::string &script,
       const std::string &page)
  {
    const std::string advice =
      " The pictures of " + page +
      " are missing: install gnuplot (Debian: gnuplot-nox) and run 'gnuplot " +
      script + "' in the output folder.";
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    std::string program = "gnuplot", argument = script;
    char *arguments[] = {program.data(), argument.data(), nullptr};
    pid_t child;
    const int failure = posix_spawnp(
      &child, program.c_str(), &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
      return "gnuplot cannot be started." + advice;
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
      ;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
      return "gnuplot failed." + advice;
    return {};
  }
} // namespace springfit
