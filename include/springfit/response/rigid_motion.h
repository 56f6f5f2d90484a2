#ifndef springfit_response_rigid_motion_h
#define springfit_response_rigid_motion_h

#include <Eigen/Core>

#include <string>

namespace springfit
{
  /** Which components of a node are held, by their direction; dim x n. */
  using HeldComponents = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

  /**
   * The rigid motion that a connected body can still make when components of
   * the nodes at @p points (dim x n, in m; n may be 0) are @p held, in words
   * such as "the rotation about the axis through (0, 0, 0) m along (1, 0, 0)".
   * Empty when there is none. Motions are small: a rotation moves no node along
   * its arm.
   */
  std::string
  free_rigid_motion(const Eigen::MatrixXd &points, const HeldComponents &held);
} // namespace springfit

#endif
