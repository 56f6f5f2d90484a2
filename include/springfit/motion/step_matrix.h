#ifndef springfit_motion_step_matrix_h
#define springfit_motion_step_matrix_h

#include <springfit/motion/moving_body.h>
#include <springfit/motion/step_system.h>
#include <springfit/springs/tangent_matrix.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /** Which nodes have entries in common in the matrices of a body's steps. */
  NodePattern
  step_pattern(const MovingBody &body);

  /** By node, whether all its components are held. */
  std::vector<bool>
  held_nodes(int dim, const MovingBody &body);


  /** The matrices of a step, assembled; see StepFactors for what they are. */
  class StepMatrix
  {
  public:
    /** @p body must outlive the object. */
    StepMatrix(int dim, const MovingBody &body);

    /** All are those at this state, with this tangent, from now on. */
    void
    linearise(const MotionState &state, Tangent tangent);

    /** The loads' stiffness alone is that at this state from now on. */
    void
    linearise_loads(const MotionState &state);

    /** K u, N. */
    Eigen::MatrixXd
    stiffness_product(const Eigen::MatrixXd &u) const;

    /**
     * Their sum, each times its factor, (dim * n_nodes)^2, of the sparsity of
     * step_pattern(); rows and columns of held unknowns are those of the unit
     * matrix. Valid until the next call.
     */
    const Eigen::SparseMatrix<double> &
    sum(const StepFactors &factors);

  private:
    void
    add_mass(double factor);

    const int dim_;
    const MovingBody &body_;

    // Of one pattern.
    TangentMatrix stiffness_, sum_;

    // Empty unless the body has dampers.
    std::vector<TangentMatrix> dampers_;

    Eigen::MatrixXd load_blocks_; // see MovingBody::load_stiffness

    // Positions among the entries: of the diagonal, and of rows and columns
    // that are held.
    std::vector<Eigen::Index> diagonal_, held_;
  };


  /**
   * An n_nodes x n_nodes matrix that resembles mass_factor M + stiffness_factor
   * K, with the tangent K at a displacement (dim x n_nodes, m), on each
   * component of a motion: K's blocks of two nodes are replaced by their mean
   * diagonal entry, 0 where that is positive, and K's diagonal keeps the sums
   * of rows 0, so that it is a Laplacian on the graph of the nodes and the
   * whole positive definite. Nodes that are held in all components have rows
   * and columns of the unit matrix. For isotropic elasticity at rest it is, up
   * to a factor, spectrally equivalent by Korn's inequality (Axelsson 1998, On
   * iterative solvers in structural mechanics: separate displacement
   * orderings). Both factors > 0.
   */
  Eigen::SparseMatrix<double>
  scalar_step_matrix(int dim,
                     const MovingBody &body,
                     const Eigen::MatrixXd &displacement,
                     double mass_factor,
                     double stiffness_factor);
} // namespace springfit

#endif
