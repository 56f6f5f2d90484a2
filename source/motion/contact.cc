#include <springfit/motion/contact.h>

namespace springfit
{
  namespace
  {
    /** How deep a point is inside, and the way out. */
    struct Depth
    {
      double value; // m, negative outside
      Eigen::VectorXd way_out;
    };

    Depth
    depth_in(const Plane &plane, const Eigen::VectorXd &x)
    {
      return {plane.normal.dot(plane.point - x), plane.normal};
    }

    Depth
    depth_in(const Sphere &sphere, const Eigen::VectorXd &x)
    {
      const Eigen::VectorXd arm = x - sphere.centre;
      const double distance     = arm.norm();
      // At the centre no way out is the shortest one: none is taken.
      return {sphere.radius - distance,
              distance > 0. ? Eigen::VectorXd(arm / distance)
                            : Eigen::VectorXd::Zero(x.size())};
    }

    template <typename F>
    void
    for_each_inside(const Obstacle &obstacle,
                    const Eigen::MatrixXd &x,
                    const double time,
                    const F &f)
    {
      const Shape shape = obstacle.at(time);
      std::visit(
        [&](const auto &solid) {
          for (Eigen::Index v = 0; v < x.cols(); ++v)
            if (const Depth depth = depth_in(solid, x.col(v)); depth.value > 0.)
              f(v, depth);
        },
        shape);
    }
  } // namespace

  double
  contact_energy(const Obstacle &obstacle,
                 const Eigen::MatrixXd &x,
                 const double time)
  {
    double energy = 0.;
    for_each_inside(obstacle, x, time, [&](Eigen::Index, const Depth &depth) {
      energy += 0.5 * obstacle.stiffness * depth.value * depth.value;
    });
    return energy;
  }

  void
  add_contact_forces(const Obstacle &obstacle,
                     const Eigen::MatrixXd &x,
                     const double time,
                     Eigen::MatrixXd &forces)
  {
    for_each_inside(
      obstacle, x, time, [&](const Eigen::Index v, const Depth &depth) {
        forces.col(v) += obstacle.stiffness * depth.value * depth.way_out;
      });
  }

  void
  add_contact_stiffness(const Obstacle &obstacle,
                        const Eigen::MatrixXd &x,
                        const double time,
                        Eigen::MatrixXd &blocks)
  {
    const Eigen::Index dim = x.rows();
    for_each_inside(
      obstacle, x, time, [&](const Eigen::Index v, const Depth &depth) {
        blocks.middleCols(dim * v, dim) +=
          obstacle.stiffness * depth.way_out * depth.way_out.transpose();
      });
  }
} // namespace springfit
