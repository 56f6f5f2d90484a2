#include <springfit/core/error.h>
#include <springfit/core/number_list.h>
#include <springfit/core/words.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace springfit
{
  namespace
  {
    constexpr double largest_number = 10000; // of numbers in a range

    std::vector<std::string>
    split_at_blanks(const std::string &text)
    {
      std::istringstream stream(text);
      return {std::istream_iterator<std::string>(stream), {}};
    }

    class RangeParser
    {
    public:
      RangeParser(const Spacing spacing, const std::string &entry)
        : spacing_(spacing), entry_(entry)
      {}

      void
      append(const std::string &item, std::vector<double> &numbers) const
      {
        const auto words = split_at_blanks(item);
        if (words.size() == 1)
          numbers.push_back(number(words[0], item));
        else if (words.size() == 5 && words[1] == "to" && words[3] == "in")
          append_range(number(words[0], item),
                       number(words[2], item),
                       number(words[4], item),
                       item,
                       numbers);
        else
          throw unreadable(item);
      }

    private:
      EntryError
      unreadable(const std::string &item) const
      {
        return EntryError(entry_,
                          "'" + item + "' cannot be read.",
                          "Give " + number_list_help() + '.');
      }

      double
      number(const std::string &word, const std::string &item) const
      {
        char *end          = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (end != word.c_str() + word.size() || !std::isfinite(value))
          throw unreadable(item);
        return value;
      }

      void
      append_range(const double lowest,
                   const double highest,
                   const double n,
                   const std::string &item,
                   std::vector<double> &numbers) const
      {
        if (!(lowest < highest))
          throw EntryError(entry_,
                           "the range '" + item +
                             "' is empty: its lowest value is not below its "
                             "highest.",
                           "Write LOWEST to HIGHEST in NUMBER, or a single "
                           "number.");
        if (!(n >= 2. && n <= largest_number && n == std::floor(n)))
          throw EntryError(entry_,
                           "the range '" + item +
                             "' has no whole number of values from 2 to 10000.",
                           "Write LOWEST to HIGHEST in NUMBER, both ends "
                           "counted.");
        if (spacing_ == Spacing::logarithmic && !(lowest > 0.))
          throw EntryError(entry_,
                           "the range '" + item +
                             "' is logarithmic, but does not begin above 0.",
                           "Give a positive lowest value.");
        for (unsigned int i = 0; i < n; ++i)
          {
            const double share = i / (n - 1.);
            // The ends as they are written.
            numbers.push_back(i == 0        ? lowest
                              : share == 1. ? highest
                              : spacing_ == Spacing::uniform
                                ? lowest + share * (highest - lowest)
                                : lowest * std::pow(highest / lowest, share));
          }
      }

      const Spacing spacing_;
      const std::string entry_;
    };
  } // namespace

  const std::string &
  number_list_help()
  {
    static const std::string help =
      "numbers, separated by commas, or ranges \"LOWEST to HIGHEST in NUMBER\" "
      "with both ends counted";
    return help;
  }

  std::vector<double>
  parse_number_list(const std::string &text,
                    const Spacing spacing,
                    const std::string &entry)
  {
    const RangeParser parser(spacing, entry);
    std::vector<double> numbers;
    for (const auto &item : split_at_commas(text))
      parser.append(item, numbers);
    if (numbers.empty())
      throw EntryError(entry,
                       "the list is empty.",
                       "Give " + number_list_help() + '.');
    return numbers;
  }
} // namespace springfit
