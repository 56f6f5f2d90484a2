#ifndef springfit_studies_unstable_motion_h
#define springfit_studies_unstable_motion_h

#include <springfit/calibration/calibrated_network.h>
#include <springfit/studies/moving_model.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /**
   * What sets a stability limit, in words: the node that moves most in a
   * motion, "node 3 at (0, 0, 0.02) m", and, of a model of springs, the spring
   * that resists it most.
   *
   * @param networks those that the model may be of
   * @param nodes places at rest, dim x n_nodes, m
   * @param shape of the motion, as they, of any size
   */
  std::string
  limiting_motion(const std::vector<CalibratedNetwork> &networks,
                  const MovingModel &model,
                  const Eigen::MatrixXd &nodes,
                  const Eigen::MatrixXd &shape);
} // namespace springfit

#endif
