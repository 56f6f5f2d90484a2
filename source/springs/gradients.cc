#include <springfit/core/error.h>
#include <springfit/springs/gradients.h>

namespace springfit
{
  Eigen::MatrixXd
  length_gradients(const Eigen::MatrixXd &points,
                   const std::vector<NodePair> &springs)
  {
    const Eigen::Index dim = points.rows();
    Eigen::MatrixXd gradients =
      Eigen::MatrixXd::Zero(points.size(), springs.size());
    for (std::size_t s = 0; s < springs.size(); ++s)
      {
        const auto [i, j]   = springs[s];
        const double length = (points.col(j) - points.col(i)).norm();
        if (!(length > 0.))
          throw RunError("Two vertices of a cell coincide, so the spring "
                         "between them has no direction.",
                         "Merge the vertices in the mesh.");
        for (Eigen::Index d = 0; d < dim; ++d)
          {
            const double n            = (points(d, j) - points(d, i)) / length;
            gradients(dim * i + d, s) = -n;
            gradients(dim * j + d, s) = n;
          }
      }
    return gradients;
  }
} // namespace springfit
