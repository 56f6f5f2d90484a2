#include <springfit/mesh/text_tokens.h>

#include <charconv>

namespace springfit
{
  TextTokens::TextTokens(const std::filesystem::path &file, const char comment)
  {
    const auto lines = read_text_lines(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
      {
        places_.push_back(lines[i].place);
        const std::string text =
          comment == '\0'
            ? lines[i].text
            : lines[i].text.substr(0, lines[i].text.find(comment));
        for (std::string &word : split_at_blanks(text))
          tokens_.push_back({std::move(word), i});
      }
    if (places_.empty())
      places_.push_back(
        {std::make_shared<const std::string>(file.string()), 1});
  }


  bool
  TextTokens::at_end() const
  {
    return next_ == tokens_.size();
  }


  const std::string &
  TextTokens::peek() const
  {
    return tokens_.at(next_).text;
  }


  const std::string &
  TextTokens::next(const std::string &what)
  {
    if (at_end())
      throw text_error(places_.back(),
                       "the file ends where " + what + " should come",
                       "It may be cut short: write it anew.");
    return tokens_[next_++].text;
  }


  const TextPlace &
  TextTokens::place() const
  {
    return next_ == 0 ? places_.front() : places_[tokens_[next_ - 1].line];
  }


  double
  TextTokens::real(const std::string &what)
  {
    const std::string &word = next(what);
    return read_real(word, place());
  }


  std::size_t
  TextTokens::count(const std::string &what)
  {
    const long value = integer(what);
    if (value < 0)
      throw text_error(place(),
                       std::to_string(value) + " stands where " + what +
                         " should");
    return value;
  }


  long
  TextTokens::integer(const std::string &what)
  {
    const std::string &word = next(what);
    long value              = 0;
    const char *begin       = word.data();
    const char *const end   = begin + word.size();
    if (word.size() > 1 && word[0] == '+')
      ++begin;
    const auto result = std::from_chars(begin, end, value);
    if (result.ec != std::errc() || result.ptr != end)
      throw text_error(place(),
                       "'" + word.substr(0, 60) + "' stands where " + what +
                         " should");
    return value;
  }


  bool
  TextTokens::goes_on_in_line() const
  {
    return next_ > 0 && !at_end() &&
           tokens_[next_].line == tokens_[next_ - 1].line;
  }


  void
  TextTokens::skip_line()
  {
    while (goes_on_in_line())
      ++next_;
  }
} // namespace springfit
