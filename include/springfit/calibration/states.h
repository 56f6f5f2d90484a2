#ifndef springfit_calibration_states_h
#define springfit_calibration_states_h

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** How a user writes such a list, for the text of an entry. */
  const std::string &
  states_help();

  /**
   * The deformation gradients F, dim x dim, of a list of homogeneous
   * deformations such as "stretch x 1.3 y 0.9, shear xy 0.3": F is the identity
   * but for the stretches on its diagonal, or for the entry (x, y), which moves
   * points along x in proportion to y. det F > 0. The list may be empty, and
   * does not name the state at rest.
   *
   * @throws EntryError when what is written is no such list, a number is no
   * decimal one, a stretch is not in [0.1, 10] or a shear not in [-10, 10], or
   * a state is at rest or given twice. @p entry names the
   * parameter.
   */
  std::vector<Eigen::MatrixXd>
  parse_states(const std::string &text, int dim, const std::string &entry);
} // namespace springfit

#endif
