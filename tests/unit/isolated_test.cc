// Work in a child process: whatever it does, the program goes on.

#include <springfit/core/isolated.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace springfit;

namespace
{
  constexpr WorkLimits enough = {60., std::size_t(1) << 30};

  WorkEnding
  ending_of(const std::function<std::string()> &work,
            const WorkLimits &limits = enough)
  {
    const IsolatedWork done = run_isolated(limits, work);
    return done.ending;
  }

  TEST(Isolated, AnswersOfAnySize)
  {
    for (const std::size_t n : {0, 1, 100000, 30000000})
      {
        const auto done =
          run_isolated(enough, [n]() { return std::string(n, '\0') + "end"; });
        EXPECT_EQ(done.ending, WorkEnding::answered);
        EXPECT_EQ(done.answer, std::string(n, '\0') + "end");
      }
  }

  TEST(Isolated, LeavesTheProgramAsItWas)
  {
    int number = 1;
    run_isolated(enough, [&number]() {
      number = 2;
      return std::string();
    });
    EXPECT_EQ(number, 1);
  }

  TEST(Isolated, CrashesAreTold)
  {
    for (const int signal : {SIGSEGV, SIGABRT, SIGKILL, SIGFPE})
      EXPECT_EQ(ending_of([signal]() {
                  std::raise(signal);
                  return std::string();
                }),
                WorkEnding::crashed);
    EXPECT_EQ(ending_of([]() -> std::string { std::abort(); }),
              WorkEnding::crashed);
    EXPECT_EQ(ending_of([]() -> std::string {
                throw std::runtime_error("nobody catches it");
              }),
              WorkEnding::crashed);
  }

  TEST(Isolated, ComplaintsAreHandedOn)
  {
    const auto thrown = run_isolated(enough, []() -> std::string {
      throw std::string("no closed loop");
    });
    EXPECT_EQ(thrown.ending, WorkEnding::crashed);
    EXPECT_EQ(thrown.answer, "no closed loop");

    const auto uncaught = run_isolated(enough, []() -> std::string {
      std::thread([]() { throw std::string("not even here"); }).join();
      return "";
    });
    EXPECT_EQ(uncaught.ending, WorkEnding::crashed);
    EXPECT_EQ(uncaught.answer, "not even here");

    EXPECT_EQ(run_isolated(enough,
                           []() -> std::string {
                             throw std::runtime_error("of a library");
                           })
                .answer,
              "");
  }

  // As a script does that ends the library's process.
  TEST(Isolated, AnExitIsNoAnswer)
  {
    EXPECT_EQ(ending_of([]() -> std::string { std::_Exit(0); }),
              WorkEnding::crashed);
  }

  TEST(Isolated, TimeIsLimited)
  {
    EXPECT_EQ(ending_of(
                []() -> std::string {
                  for (volatile unsigned int i = 0;; i = i + 1)
                    ;
                },
                {0.2, std::size_t(1) << 30}),
              WorkEnding::too_slow);
  }

  TEST(Isolated, MemoryIsLimited)
  {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "AddressSanitizer reserves terabytes";
#endif
    EXPECT_EQ(ending_of(
                []() {
                  const std::vector<char> much(std::size_t(1) << 30, 'x');
                  return std::string(much.begin(), much.begin() + 10);
                },
                {60., std::size_t(100) << 20}),
              WorkEnding::too_large);
  }
} // namespace
