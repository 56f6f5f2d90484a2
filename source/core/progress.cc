#include <springfit/core/progress.h>

#include <unistd.h>

#include <iostream>

namespace springfit
{
  Progress::Progress(const std::string &what,
                     const std::size_t n_steps,
                     const bool visible)
    : what_(what)
    , n_steps_(n_steps)
    , visible_(visible && isatty(STDOUT_FILENO))
    , next_(Clock::now() + std::chrono::seconds(1))
  {}

  Progress::~Progress()
  {
    if (shown_)
      std::cout << "\r\033[K" << std::flush;
  }

  void
  Progress::step()
  {
    ++n_done_;
    if (!visible_ || Clock::now() < next_)
      return;
    std::cout << '\r' << what_ << ": " << n_done_ << " of " << n_steps_
              << std::flush;
    shown_ = true;
    next_  = Clock::now() + std::chrono::milliseconds(100);
  }
} // namespace springfit
