#include <springfit/core/parameter_text.h>
#include <springfit/core/trimmed.h>
#include <springfit/core/words.h>

#include <deal.II/base/exceptions.h>

#include <sstream>

namespace springfit
{
  std::vector<ParameterLine>
  scan_parameters(std::istream &file)
  {
    std::vector<ParameterLine> lines;
    std::vector<std::string> sections;
    unsigned int number = 0;
    for (std::string line; std::getline(file, line);)
      {
        ++number;
        line = trimmed(line.substr(0, line.find('#')));
        std::istringstream words(line);
        std::string first;
        words >> first;
        if (first == "subsection" || first == "SUBSECTION")
          sections.push_back(trimmed(line.substr(first.size())));
        else if ((first == "end" || first == "END") && !sections.empty())
          sections.pop_back();
        else if (first == "set" || first == "SET")
          {
            const auto equals = line.find('=');
            const auto name   = trimmed(line.substr(3, equals - 3));
            lines.push_back(
              {join(sections, "/") + (sections.empty() ? "" : "/") + name,
               equals == std::string::npos ? ""
                                           : trimmed(line.substr(equals + 1)),
               number});
          }
      }
    return lines;
  }

  std::string
  with_entries(const std::string &text,
               const std::map<std::string, std::string> &values)
  {
    std::istringstream whole(text);
    std::map<unsigned int, ParameterLine> changed;
    for (auto &line : scan_parameters(whole))
      if (const auto value = values.find(line.entry); value != values.end())
        {
          line.value = value->second;
          changed.emplace(line.line, line);
        }
    Assert(changed.size() == values.size(), dealii::ExcInternalError());

    std::istringstream lines(text);
    std::string result;
    unsigned int number = 0;
    for (std::string line; std::getline(lines, line);)
      {
        const auto change = changed.find(++number);
        result += change == changed.end() ? line
                                          : line.substr(0, line.find('=') + 1) +
                                              ' ' + change->second.value;
        result += '\n';
      }
    return result;
  }
} // namespace springfit
