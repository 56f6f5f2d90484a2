#include <springfit/exports/written_numbers.h>

#include <charconv>

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
} // namespace springfit
