#include <springfit/exports/written_text.h>

#include <charconv>
#include <cstddef>

namespace springfit
{
  std::string
  exact(const double number)
  {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof(text), number).ptr;
    return {text, end};
  }

  std::string
  exact(const Eigen::Vector3d &vector)
  {
    return exact(vector, " ");
  }

  std::string
  exact(const Eigen::Vector3d &vector, const std::string &separator)
  {
    return exact(vector[0]) + separator + exact(vector[1]) + separator +
           exact(vector[2]);
  }

  std::string
  in_comment(std::string text)
  {
    for (std::size_t i = text.find("--"); i != std::string::npos;
         i             = text.find("--", i))
      text.insert(i + 1, " ");
    return text;
  }
} // namespace springfit
