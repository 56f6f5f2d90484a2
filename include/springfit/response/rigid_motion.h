#ifndef springfit_response_rigid_motion_h
#define springfit_response_rigid_motion_h

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * The rigid motion that a connected body can still make when the nodes
   * @p supports (dim x n, in m; n may be 0) are held in all components, in
   * words such as "rotation about the axis through (0, 0, 0) along (1, 0, 0)".
   * Empty when there is none.
   */
  std::string
  free_rigid_motion(const Eigen::MatrixXd &supports);
} // namespace springfit

#endif
