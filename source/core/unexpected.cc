#include <springfit/core/unexpected.h>

#include <deal.II/base/exceptions.h>

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
  } // namespace

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
      return RunError("The memory of this machine does not suffice.",
                      "Choose a larger 'Cell size'.");
    return RunError("The run failed unexpectedly: " + message_of(error) + '.',
                    "Please report this with the parameter file.");
  }
} // namespace springfit
