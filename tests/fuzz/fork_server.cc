// springfit as a server for scripts/fuzz: of the second that a run takes, half
// is the loading of 200 libraries, which happens here once. A case is the
// number of its words, then each word as its length and its bytes: the folder
// to run in and the arguments. The answer is the process's number and, when it
// has ended, its status as waitpid() has it.

#define main springfit_main
#include "../../source/main.cc"
#undef main

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
  std::vector<std::string>
  read_words()
  {
    std::size_t n = 0;
    std::cin >> n;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < n && std::cin; ++i)
      {
        std::size_t length = 0;
        std::cin >> length;
        std::cin.get();
        std::string word(length, '\0');
        std::cin.read(word.data(), length);
        words.push_back(word);
      }
    return words;
  }

  void
  redirect(const int stream, const char *file, const int flags)
  {
    const int opened = open(file, flags, 0644);
    dup2(opened, stream);
    close(opened);
  }

  [[noreturn]] void
  run_case(std::vector<std::string> words)
  {
    setsid();
    if (chdir(words[0].c_str()) != 0)
      _exit(99);
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, "stdout.txt", O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, "stderr.txt", O_WRONLY | O_CREAT);
    words[0] = "springfit";
    std::vector<char *> arguments;
    for (std::string &word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::exit(springfit_main(words.size(), arguments.data()));
  }
} // namespace

int
main()
{
  while (true)
    {
      const auto words = read_words();
      if (words.empty())
        return 0;
      const pid_t child = fork();
      if (child == 0)
        run_case(words);
      std::cout << child << std::endl;
      int status = 0;
      waitpid(child, &status, 0);
      std::cout << status << std::endl;
    }
}
