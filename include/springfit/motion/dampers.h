#ifndef springfit_motion_dampers_h
#define springfit_motion_dampers_h

#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace springfit
{
  /**
   * A damper of the same coefficient between each pair of nodes, along the line
   * between them: the force on node i is c ((v_j - v_i) . n) n with the unit
   * vector n from x_i to x_j. Motions as a rigid body are not damped.
   */
  struct Dampers
  {
    double coefficient = 0.; // c, N s/m
    std::vector<std::array<unsigned int, 2>> pairs;

    /** The places of the nodes at rest, dim x n_nodes, m. */
    Eigen::MatrixXd nodes;
  };

  bool
  are_there(const Dampers &dampers);

  /** C v, N, at a displacement (m) and velocity (m/s); all dim x n_nodes. */
  Eigen::MatrixXd
  damper_product(const Dampers &dampers,
                 const Eigen::MatrixXd &displacement,
                 const Eigen::MatrixXd &velocity);

  /** Add C, N s/m. */
  void
  add_damper_matrix(const Dampers &dampers,
                    const Eigen::MatrixXd &displacement,
                    TangentMatrix &matrix);

  void
  add_to_pattern(const Dampers &dampers, NodePattern &pattern);
} // namespace springfit

#endif
