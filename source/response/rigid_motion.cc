#include <springfit/response/rigid_motion.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace springfit
{
  namespace
  {
    std::string
    text_of(const Eigen::VectorXd &vector)
    {
      std::ostringstream text;
      text.precision(3);
      text << '(';
      for (Eigen::Index d = 0; d < vector.size(); ++d)
        text << (d == 0 ? "" : ", ")
             << (std::abs(vector[d]) < 1e-12 ? 0. : vector[d]);
      text << ')';
      return text.str();
    }

    /** Of a direction and its opposite, the one with a positive sum. */
    Eigen::VectorXd
    pointing_up(const Eigen::VectorXd &direction)
    {
      return direction.sum() < 0. ? Eigen::VectorXd(-direction) : direction;
    }

    /**
     * What a translation (first dim columns) and a rotation about the origin,
     * by an angle times @p length, do to a component at an arm.
     */
    Eigen::RowVectorXd
    row_of(const Eigen::VectorXd &arm,
           const Eigen::Index d,
           const double length)
    {
      const Eigen::Index dim = arm.size();
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(dim == 2 ? 3 : 6);
      row[d]                 = 1.;
      if (dim == 2)
        row[2] = (d == 0 ? -arm[1] : arm[0]) / length;
      else
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          row[3 + axis] =
            Eigen::Vector3d::Unit(axis).cross(Eigen::Vector3d(arm))[d] / length;
      return row;
    }

    /** A motion of row_of() about @p centre, in words. */
    std::string
    describe(const Eigen::VectorXd &motion,
             const Eigen::VectorXd &centre,
             const double length)
    {
      const Eigen::Index dim         = centre.size();
      const Eigen::VectorXd velocity = motion.head(dim);
      const Eigen::VectorXd turning = motion.tail(motion.size() - dim) / length;
      if (turning.norm() * length < 1e-6 * velocity.norm())
        return "the translation along " +
               text_of(pointing_up(velocity.normalized()));
      if (dim == 2)
        return "the rotation about the point " +
               text_of(centre + Eigen::Vector2d(-velocity[1], velocity[0]) /
                                  turning[0]) +
               " m";
      const Eigen::Vector3d axis = turning;
      return "the rotation about the axis through " +
             text_of(centre +
                     Eigen::VectorXd(axis.cross(Eigen::Vector3d(velocity)) /
                                     axis.squaredNorm())) +
             " m along " + text_of(pointing_up(axis.normalized()));
    }
  } // namespace

  std::string
  free_rigid_motion(const Eigen::MatrixXd &points, const HeldComponents &held)
  {
    const Eigen::Index dim = points.rows();
    if (points.cols() == 0 || held.count() == 0)
      return "every translation and rotation (nothing is held)";

    const Eigen::VectorXd centre = points.rowwise().mean();
    const Eigen::MatrixXd arms   = points.colwise() - centre;
    const double size            = arms.colwise().norm().maxCoeff();
    // Nodes that are one but for rounding have no arms.
    const bool are_one  = size <= 1e-10 * points.norm();
    const double length = are_one ? 1. : size;

    Eigen::MatrixXd rows(held.count(), dim == 2 ? 3 : 6);
    Eigen::Index n = 0;
    for (Eigen::Index v = 0; v < points.cols(); ++v)
      for (Eigen::Index d = 0; d < dim; ++d)
        if (held(d, v))
          rows.row(n++) = row_of(are_one ? Eigen::VectorXd::Zero(dim)
                                         : Eigen::VectorXd(arms.col(v)),
                                 d,
                                 length);

    // Of the normal matrix, which is small however many nodes there are.
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows.transpose() * rows,
                                                Eigen::ComputeFullV);
    const auto &values       = svd.singularValues();
    const Eigen::Index rank  = (values.array() > 1e-14 * values[0]).count();
    const Eigen::Index n_all = rows.cols();
    if (rank == n_all)
      return "";
    if (dim == 3 && are_one && held.all())
      return "every rotation about the point " + text_of(centre) + " m";
    return describe(svd.matrixV().col(n_all - 1), centre, length) +
           (n_all - rank > 1
              ? " and " + std::to_string(n_all - rank - 1) + " more"
              : "");
  }
} // namespace springfit
