#include <springfit/core/error.h>
#include <springfit/springs/angle.h>
#include <springfit/springs/gradients.h>

#include <string>

namespace springfit
{
  namespace
  {
    [[noreturn]] void
    throw_degenerate(const NodeTriple &angle)
    {
      throw RunError("The angle of a cell at its vertex " +
                       std::to_string(angle[1]) + " between its vertices " +
                       std::to_string(angle[0]) + " and " +
                       std::to_string(angle[2]) +
                       " is straight or folded, so an angular spring has no "
                       "direction there.",
                     "Mend the cell in the mesh or fit without angles.");
    }

    template <int dim>
    Eigen::MatrixXd
    angle_gradients(const Eigen::MatrixXd &points,
                    const std::vector<NodeTriple> &angles)
    {
      Eigen::MatrixXd gradients =
        Eigen::MatrixXd::Zero(points.size(), angles.size());
      for (std::size_t t = 0; t < angles.size(); ++t)
        {
          const auto [a, m, c] = angles[t];
          const Vector<dim> u  = points.col(a) - points.col(m);
          const Vector<dim> v  = points.col(c) - points.col(m);
          if (is_degenerate_angle<dim>(u, v))
            throw_degenerate(angles[t]);
          const Vector<3 *dim> gradient = angle_gradient<dim>(u, v);
          for (unsigned int n = 0; n < 3; ++n)
            gradients.block<dim, 1>(dim * angles[t][n], t) =
              gradient.template segment<dim>(dim * n);
        }
      return gradients;
    }
  } // namespace

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

  Eigen::MatrixXd
  angle_gradients(const Eigen::MatrixXd &points,
                  const std::vector<NodeTriple> &angles)
  {
    return points.rows() == 2 ? angle_gradients<2>(points, angles)
                              : angle_gradients<3>(points, angles);
  }
} // namespace springfit
