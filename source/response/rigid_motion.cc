#include <springfit/response/rigid_motion.h>

#include <Eigen/SVD>

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
  } // namespace

  std::string
  free_rigid_motion(const Eigen::MatrixXd &supports)
  {
    const Eigen::Index dim = supports.rows();
    if (supports.cols() == 0)
      return "every translation and rotation (nothing is held)";

    const Eigen::VectorXd centre = supports.rowwise().mean();
    const Eigen::MatrixXd arms   = supports.colwise() - centre;

    // With one node held the rotations about it are free; in space, with all
    // of them on a line, the rotation about that line.
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(arms, Eigen::ComputeThinU);
    const double length    = svd.singularValues()[0];
    const double tolerance = 1e-10 * (1e-300 + supports.norm() + length);
    if (length <= tolerance)
      return std::string(dim == 2 ? "the rotation" : "every rotation") +
             " about the point " + text_of(centre) + " m";
    const bool on_a_line =
      svd.singularValues().size() < 2 || svd.singularValues()[1] <= tolerance;
    if (dim == 3 && on_a_line)
      return "the rotation about the axis through " + text_of(centre) +
             " m along " + text_of(pointing_up(svd.matrixU().col(0)));
    return "";
  }
} // namespace springfit
