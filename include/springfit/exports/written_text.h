#ifndef springfit_exports_written_text_h
#define springfit_exports_written_text_h

#include <Eigen/Core>

#include <string>

namespace springfit
{
  /** The fewest digits that read back as the same double. */
  std::string
  exact(double number);

  /** Three of them with blanks between. */
  std::string
  exact(const Eigen::Vector3d &vector);

  /** With @p separator between them. */
  std::string
  exact(const Eigen::Vector3d &vector, const std::string &separator);

  /** A text for a comment of XML, which must not have two hyphens in a row. */
  std::string
  in_comment(std::string text);
} // namespace springfit

#endif
