#include <springfit/motion/contact.h>

namespace springfit
{
  namespace
  {
    /** How deep a point is inside, and the way out. */
    template <int dim>
    struct Depth
    {
      double value; // m, negative outside
      Eigen::Matrix<double, dim, 1> way_out;
    };

    template <int dim>
    Depth<dim>
    depth_in(const Plane &plane, const Eigen::Matrix<double, dim, 1> &x)
    {
      const Eigen::Matrix<double, dim, 1> normal = plane.normal;
      return {normal.dot(plane.point - x), normal};
    }

    template <int dim>
    Depth<dim>
    depth_in(const Sphere &sphere, const Eigen::Matrix<double, dim, 1> &x)
    {
      const Eigen::Matrix<double, dim, 1> arm = x - sphere.centre;
      const double distance                   = arm.norm();
      // At the centre no way out is the shortest one: none is taken.
      return {sphere.radius - distance,
              distance > 0. ? (arm / distance).eval() : 0. * arm};
    }

    template <int dim, typename F>
    void
    for_each_inside(const Shape &shape, const Eigen::MatrixXd &x, const F &f)
    {
      std::visit(
        [&](const auto &solid) {
          for (Eigen::Index v = 0; v < x.cols(); ++v)
            {
              const Eigen::Matrix<double, dim, 1> place = x.col(v);
              const Depth<dim> depth = depth_in<dim>(solid, place);
              if (depth.value > 0.)
                f(v, depth.value, depth.way_out);
            }
        },
        shape);
    }

    /** Calls @p f(node, depth, way out) of what is inside. */
    template <typename F>
    void
    for_each_inside(const Obstacle &obstacle,
                    const Eigen::MatrixXd &x,
                    const double time,
                    const F &f)
    {
      const Shape shape = obstacle.at(time);
      if (x.rows() == 2)
        for_each_inside<2>(shape, x, f);
      else
        for_each_inside<3>(shape, x, f);
    }
  } // namespace

  double
  contact_energy(const Obstacle &obstacle,
                 const Eigen::MatrixXd &x,
                 const double time)
  {
    double energy = 0.;
    for_each_inside(obstacle,
                    x,
                    time,
                    [&](Eigen::Index, const double depth, const auto &) {
                      energy += 0.5 * obstacle.stiffness * depth * depth;
                    });
    return energy;
  }

  void
  add_contact_forces(const Obstacle &obstacle,
                     const Eigen::MatrixXd &x,
                     const double time,
                     Eigen::MatrixXd &forces)
  {
    for_each_inside(obstacle,
                    x,
                    time,
                    [&](const Eigen::Index v,
                        const double depth,
                        const auto &way_out) {
                      forces.col(v) += obstacle.stiffness * depth * way_out;
                    });
  }

  void
  add_contact_stiffness(const Obstacle &obstacle,
                        const Eigen::MatrixXd &x,
                        const double time,
                        Eigen::MatrixXd &blocks)
  {
    const Eigen::Index dim = x.rows();
    for_each_inside(obstacle,
                    x,
                    time,
                    [&](const Eigen::Index v, double, const auto &way_out) {
                      blocks.middleCols(dim * v, dim) +=
                        obstacle.stiffness * way_out * way_out.transpose();
                    });
  }
} // namespace springfit
