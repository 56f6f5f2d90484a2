#include <springfit/mesh/known_numbers.h>

namespace springfit
{
  KnownNumbers::KnownNumbers(const std::string &what) : what_(what)
  {}


  void
  KnownNumbers::add(const std::size_t number, const TextPlace &place)
  {
    const auto [old, is_new] = line_of_.emplace(number, place.line);
    if (!is_new)
      throw text_error(place,
                       "the " + what_ + ' ' + std::to_string(number) +
                         " is there a second time" +
                         (old->second == 0
                            ? ""
                            : ", after line " + std::to_string(old->second)),
                       "Give each " + what_ + " a number of its own.");
  }


  void
  KnownNumbers::check(const std::size_t number,
                      const std::string &user,
                      const TextPlace &place) const
  {
    if (line_of_.count(number) == 0)
      throw text_error(place,
                       user + " has the " + what_ + ' ' +
                         std::to_string(number) + ", which is not there",
                       "The file may be cut short: write it anew.");
  }


  std::size_t
  KnownNumbers::size() const
  {
    return line_of_.size();
  }
} // namespace springfit
