#ifndef springfit_core_interruption_h
#define springfit_core_interruption_h

namespace springfit
{
  /**
   * While there is such an object, SIGINT and SIGTERM do not end the program
   * but are remembered, so that it can leave what it does at a good moment.
   */
  class Interruption
  {
  public:
    Interruption();
    ~Interruption();

    Interruption(const Interruption &) = delete;
    Interruption &
    operator=(const Interruption &) = delete;

    /** Whether one of them has arrived. */
    bool
    is_asked_for() const;
  };
} // namespace springfit

#endif
