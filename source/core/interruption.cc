#include <springfit/core/interruption.h>

#include <csignal>

namespace springfit
{
  namespace
  {
    volatile std::sig_atomic_t has_arrived = 0;

    void
    remember(int)
    {
      has_arrived = 1;
    }
  } // namespace

  Interruption::Interruption()
  {
    has_arrived = 0;
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
  }

  Interruption::~Interruption()
  {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }

  bool
  Interruption::is_asked_for() const
  {
    return has_arrived != 0;
  }
} // namespace springfit
