#ifndef springfit_motion_contact_h
#define springfit_motion_contact_h

#include <Eigen/Core>

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace springfit
{
  /** What is behind it, against the normal, is solid. */
  struct Plane
  {
    Eigen::VectorXd point;  // m
    Eigen::VectorXd normal; // of length 1
  };

  struct Sphere
  {
    Eigen::VectorXd centre; // m
    double radius;          // m
  };

  using Shape = std::variant<Plane, Sphere>;

  /**
   * Something solid that moves as it likes. It pushes each node that is inside
   * it along its normal there, without friction, with a force of @p stiffness
   * times the depth.
   */
  struct Obstacle
  {
    std::string name;
    std::function<Shape(double time)> at;
    double stiffness; // N/m
  };

  // Places @p x of the nodes are dim x n_nodes, in m.

  /** The energy stiffness depth^2 / 2 of all nodes, J. */
  double
  contact_energy(const Obstacle &obstacle,
                 const Eigen::MatrixXd &x,
                 double time);

  /** Add the forces on the nodes, N. */
  void
  add_contact_forces(const Obstacle &obstacle,
                     const Eigen::MatrixXd &x,
                     double time,
                     Eigen::MatrixXd &forces);

  /**
   * Add stiffness n n^T to the block of each node inside, N/m; dim x
   * (dim * n_nodes). It is the derivative of the force but for the part that
   * comes with a sphere's curvature, which is negative.
   */
  void
  add_contact_stiffness(const Obstacle &obstacle,
                        const Eigen::MatrixXd &x,
                        double time,
                        Eigen::MatrixXd &blocks);
} // namespace springfit

#endif
