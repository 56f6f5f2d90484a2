#ifndef springfit_motion_moving_body_h
#define springfit_motion_moving_body_h

#include <springfit/motion/dampers.h>
#include <springfit/motion/stable_step.h>
#include <springfit/response/elastic_body.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <vector>

namespace springfit
{
  /** Where a body is and how it moves; dim x n_nodes each. */
  struct MotionState
  {
    double time = 0.;             // s
    Eigen::MatrixXd displacement; // m
    Eigen::MatrixXd velocity;     // m/s
    Eigen::MatrixXd acceleration; // m/s^2; of generalised alpha only
  };


  /**
   * A body that obeys M a + C v + grad U(x) = loads where it is not held. C is
   * that of the dampers, and Rayleigh's with the tangent stiffness at the
   * beginning of a step, so that a body which turns as a whole is not damped by
   * its stiffness.
   */
  struct MovingBody
  {
    const ElasticBody *elastic; // never null, outlives this

    /** Of each node, kg, positive: the lumped mass. */
    Eigen::VectorXd mass;

    /**
     * The consistent mass of n_nodes x n_nodes, which all components share, in
     * the lumped one's place; without entries there is none.
     */
    Eigen::SparseMatrix<double> consistent_mass;

    RayleighDamping damping;
    Dampers dampers;

    /** A flag per unknown, dim * v + d: it follows @p support. */
    std::vector<bool> held;

    /** Adds the forces on the nodes, N, to @p forces; may be empty. */
    std::function<void(const MotionState &state, Eigen::MatrixXd &forces)>
      loads;

    /**
     * Adds the positive semidefinite part of - d loads / d x, N/m, to
     * @p blocks: dim x (dim * n_nodes), a block for each node, on which alone
     * its load depends. May be empty: none.
     */
    std::function<void(const MotionState &state, Eigen::MatrixXd &blocks)>
      load_stiffness;

    /** Above what load_stiffness makes of any node, N/m. */
    double largest_load_stiffness = 0.;

    /**
     * Sets the displacements of held unknowns, m, at a time; may be empty: they
     * stay where they are. Others that it sets are of no account.
     */
    std::function<void(double time, Eigen::MatrixXd &displacement)> support;

    /** Forces whose norm is less are rounding errors, N. */
    double rounding = 0.;
  };

  /** M u, for velocities kg m/s; dim x n_nodes. */
  Eigen::MatrixXd
  mass_product(const MovingBody &body, const Eigen::MatrixXd &u);

  // In J.

  double
  kinetic_energy(const MovingBody &body, const MotionState &state);

  /** Of the springs or cells alone, without loads. */
  double
  elastic_energy(const MovingBody &body, const MotionState &state);

  /** kg m/s */
  Eigen::VectorXd
  momentum(const MovingBody &body, const MotionState &state);

  /** Of what is not held, in the unit of @p forces (dim x n_nodes). */
  double
  norm_of_free(const MovingBody &body, const Eigen::MatrixXd &forces);

  /** loads - grad U, N; dim x n_nodes. */
  Eigen::MatrixXd
  driving_forces(const MovingBody &body, const MotionState &state);

  /** Set what is held in @p values to those of @p others. */
  void
  copy_held(const MovingBody &body,
            const Eigen::MatrixXd &others,
            Eigen::MatrixXd &values);

  /**
   * The velocity and the acceleration of what is held, from its places at
   * @p time and @p interval (s) before and after; 0 elsewhere. m/s and m/s^2.
   */
  struct SupportMotion
  {
    Eigen::MatrixXd velocity, acceleration;
  };

  SupportMotion
  motion_of_supports(const MovingBody &body, double time, double interval);

  /** Where held unknowns are at a time, others as @p displacement has them. */
  Eigen::MatrixXd
  with_supports(const MovingBody &body,
                double time,
                const Eigen::MatrixXd &displacement);
} // namespace springfit

#endif
