#ifndef springfit_core_error_h
#define springfit_core_error_h

#include <stdexcept>
#include <string>

namespace springfit
{
  /**
   * Something that the user can mend: the program was called wrongly or its
   * input is wrong. Ends the program with status 2.
   *
   * @p what says what is wrong, with file, line, entry and value as far as
   * they are known; @p mend says how to mend it. Both are full sentences.
   */
  class InputError : public std::runtime_error
  {
  public:
    InputError(const std::string &what, const std::string &mend)
      : std::runtime_error(what + ' ' + mend)
    {}

    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {}
  };


  /**
   * A wrong value of a parameter. @p entry is its full name, as in
   * "Geometry/Cell size" (or "Study" at the top level), so that whoever
   * reports the error can add the file and the line where it stands.
   */
  class EntryError : public InputError
  {
  public:
    EntryError(const std::string &entry,
               const std::string &what,
               const std::string &mend)
      : InputError(entry + ": " + what, mend), entry(entry)
    {}

    /** An error whose message is already complete. */
    EntryError(const std::string &entry, const std::string &message)
      : InputError(message), entry(entry)
    {}

    const std::string entry;
  };


  /**
   * The input was accepted but the run failed: a solver did not converge, a
   * disk is full. Ends the program with status 1.
   */
  class RunError : public std::runtime_error
  {
  public:
    RunError(const std::string &what, const std::string &mend)
      : std::runtime_error(what + ' ' + mend)
    {}

    explicit RunError(const std::string &message) : std::runtime_error(message)
    {}
  };
} // namespace springfit

#endif
