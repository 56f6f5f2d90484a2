#include <springfit/core/words.h>
#include <springfit/mesh/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

namespace springfit
{
  namespace
  {
    constexpr const char *blanks = " \t\f\v";

    std::string
    shortened(const std::string &text)
    {
      constexpr std::size_t longest = 60;
      return text.size() <= longest ? text : text.substr(0, longest) + "...";
    }
  } // namespace


  std::vector<TextLine>
  read_text_lines(const std::filesystem::path &file)
  {
    const auto name = std::make_shared<const std::string>(file.string());
    std::ifstream stream(file, std::ios::binary);
    std::stringstream content;
    if (!std::filesystem::is_regular_file(file) || !stream ||
        !(content << stream.rdbuf()))
      throw InputError("Mesh file '" + *name +
                         "' cannot be read, or it is empty.",
                       "Name a file that can.");

    std::string text = content.str();
    if (text.find('\0') != std::string::npos)
      throw InputError("Mesh file '" + *name +
                         "' is not a text: it holds bytes 0.",
                       "Save it as a text in ASCII or UTF-8.");
    if (text.rfind("\xEF\xBB\xBF", 0) == 0)
      text.erase(0, 3);

    std::vector<TextLine> lines;
    for (std::size_t begin = 0; begin < text.size();)
      {
        const std::size_t end =
          std::min(text.find_first_of("\r\n", begin), text.size());
        lines.push_back({text.substr(begin, end - begin),
                         {name, static_cast<unsigned int>(lines.size() + 1)}});
        begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
      }
    return lines;
  }


  InputError
  text_error(const TextPlace &place,
             const std::string &what,
             const std::string &mend)
  {
    const std::string line =
      place.line == 0 ? "" : ", line " + std::to_string(place.line) + ',';
    return InputError("Mesh file '" + *place.file + "'" + line +
                        " cannot be read: " + what + ".",
                      mend);
  }


  std::string
  in_capitals(std::string text)
  {
    for (char &c : text)
      c = std::toupper(static_cast<unsigned char>(c));
    return text;
  }



  std::vector<std::string>
  split_fields(const std::string &text, const char separator)
  {
    std::vector<std::string> fields;
    std::size_t begin = 0;
    while (begin <= text.size())
      {
        const std::size_t end =
          std::min(text.find(separator, begin), text.size());
        fields.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
      }
    return fields;
  }


  std::vector<std::string>
  split_at_blanks(const std::string &text)
  {
    std::vector<std::string> pieces;
    std::size_t begin = text.find_first_not_of(blanks);
    while (begin != std::string::npos)
      {
        const std::size_t end = text.find_first_of(blanks, begin);
        pieces.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(blanks, end);
      }
    return pieces;
  }


  double
  read_real(const std::string &text, const TextPlace &place)
  {
    std::string number = text;
    for (char &c : number)
      if (c == 'd' || c == 'D')
        c = 'e';
    if (number.size() > 1 && number[0] == '+' && number[1] != '-')
      number.erase(0, 1);

    double value          = 0.;
    const char *const end = number.data() + number.size();
    const auto result     = std::from_chars(number.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
      throw text_error(place,
                       "'" + shortened(text) + "' is not a finite number");
    return value;
  }


  std::size_t
  read_label(const std::string &text, const TextPlace &place)
  {
    constexpr std::size_t largest = std::size_t(1) << 53;
    std::size_t value             = 0;
    const char *const end         = text.data() + text.size();
    const auto result             = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || value == 0 ||
        value > largest)
      throw text_error(place,
                       "'" + shortened(text) +
                         "' is not the number of a node or an element");
    return value;
  }


  unsigned int
  checked_id(const long number, const std::string &what, const TextPlace &place)
  {
    constexpr long largest = 2147483647;
    if (number < 0 || number > largest)
      throw text_error(place,
                       what + ' ' + std::to_string(number) +
                         " is no id, which is from 0 to " +
                         std::to_string(largest),
                       "Number materials and boundaries otherwise.");
    return number;
  }


  std::string
  join_some(const std::vector<std::string> &words, const unsigned int n_named)
  {
    if (words.size() <= n_named)
      return join(words);
    return join({words.begin(), words.begin() + n_named}) + " and " +
           std::to_string(words.size() - n_named) + " more";
  }
} // namespace springfit
