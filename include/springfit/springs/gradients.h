#ifndef springfit_springs_gradients_h
#define springfit_springs_gradients_h

#include <springfit/springs/cell_topology.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  /**
   * The gradients b_s of the springs' lengths with respect to all coordinates
   * of a cell: -n at node i, n at node j, zero elsewhere.
   *
   * @param points dim x n_nodes, m
   * @param springs pairs of nodes
   * @return (dim * n_nodes) x n_springs; row dim * v + d is component d of
   * node v. The tangent of the cell at rest is B diag(k) B^T.
   *
   * @throws RunError when the two nodes of a spring coincide.
   */
  Eigen::MatrixXd
  length_gradients(const Eigen::MatrixXd &points,
                   const std::vector<NodePair> &springs);

  /**
   * The gradients of angles with respect to all coordinates of a cell; see
   * angle.h.
   *
   * @param points dim x n_nodes, m
   * @param angles as {end, middle, end}
   * @return (dim * n_nodes) x n_angles, rad/m, in the rows of
   * length_gradients. The tangent of angular springs at rest is
   * B diag(k) B^T.
   *
   * @throws RunError when an angle is straight or folded, or when one of its
   * arms has no length; it names the vertices.
   */
  Eigen::MatrixXd
  angle_gradients(const Eigen::MatrixXd &points,
                  const std::vector<NodeTriple> &angles);
} // namespace springfit

#endif
