#include <springfit/core/long_values.h>
#include <springfit/core/parameter_text.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace springfit
{
  std::string
  without_long_values(std::string message, const ParameterSource &source)
  {
    constexpr std::size_t longest = 200, kept = 80;
    const auto shorten = [&](const std::size_t at, const std::size_t length) {
      message.replace(at + kept, length - 2 * kept, " ... ");
    };

    std::vector<std::string> values = source.overrides;
    for (const auto &text : source.overrides)
      values.push_back(text.substr(
        std::min(text.find_first_not_of("= \t", text.find('=')), text.size())));
    // A pipe would block.
    std::error_code ignored;
    if (std::filesystem::is_regular_file(source.file, ignored))
      {
        std::ifstream file(source.file);
        for (const auto &line : scan_parameters(file))
          values.push_back(line.value);
      }
    for (const auto &value : values)
      if (value.size() > longest)
        for (std::size_t at; (at = message.find(value)) != std::string::npos;)
          shorten(at, value.size());

    for (char &c : message)
      if (static_cast<unsigned char>(c) < ' ')
        c = ' ';
    for (std::size_t begin = 0; begin < message.size();)
      {
        const auto end = std::min(message.find(' ', begin), message.size());
        if (end - begin > longest)
          {
            shorten(begin, end - begin);
            begin += 2 * kept;
          }
        else
          begin = end + 1;
      }
    return message;
  }
} // namespace springfit
