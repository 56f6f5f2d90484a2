#ifndef springfit_core_progress_h
#define springfit_core_progress_h

#include <chrono>
#include <cstddef>
#include <string>

namespace springfit
{
  /**
   * Says on a terminal how far a long loop has come, at most ten times a
   * second and not before its first second has passed; says nothing when the
   * screen is not a terminal.
   */
  class Progress
  {
  public:
    /** @p what names the steps, as in "fits"; @p visible on one rank only. */
    Progress(const std::string &what, std::size_t n_steps, bool visible);

    /** Wipes the line. */
    ~Progress();

    void
    step();

  private:
    using Clock = std::chrono::steady_clock;

    const std::string what_;
    const std::size_t n_steps_;
    const bool visible_;
    std::size_t n_done_ = 0;
    Clock::time_point next_;
    bool shown_ = false;
  };
} // namespace springfit

#endif
