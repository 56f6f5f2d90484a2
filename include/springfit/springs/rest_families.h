#ifndef springfit_springs_rest_families_h
#define springfit_springs_rest_families_h

#include <springfit/core/cell_kind.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/family.h>
#include <springfit/springs/spring_law.h>

#include <Eigen/Core>

#include <vector>

namespace springfit
{
  // Families of one cell whose springs are at rest where its vertices are, at
  // @p points (dim x n_nodes, m). Nodes are positions in @p points.

  /** @param k N/m, one per pair */
  Family
  lengths_at_rest(const Eigen::MatrixXd &points,
                  const std::vector<NodePair> &pairs,
                  const Eigen::Ref<const Eigen::VectorXd> &k,
                  SpringLaw law);

  /**
   * @param k N m, one per angle
   *
   * @throws std::logic_error when an angle is straight or folded: fits refuse
   * it, see angle_gradients.
   */
  Family
  angles_at_rest(const Eigen::MatrixXd &points,
                 const std::vector<NodeTriple> &angles,
                 const Eigen::Ref<const Eigen::VectorXd> &k);

  /** @param k of the volume, see volumes() */
  Family
  volume_at_rest(const Eigen::MatrixXd &points, CellKind kind, double k);

  /** The energy stiffness q_a q_b of the elongations of two pairs of nodes. */
  struct LengthCoupling
  {
    // Positions in a list of pairs, a < b.
    unsigned int a;
    unsigned int b;

    double stiffness; // N/m
  };

  Family
  couplings_at_rest(const Eigen::MatrixXd &points,
                    const std::vector<NodePair> &pairs,
                    const std::vector<LengthCoupling> &couplings,
                    SpringLaw law);
} // namespace springfit

#endif
