#include <springfit/fit/object/free_body.h>
#include <springfit/fit/object/free_motions.h>

#include <Eigen/Eigenvalues>

namespace springfit
{
  namespace
  {
    /** The motions of node @p v alone that cost no energy, dim x n. */
    Eigen::MatrixXd
    free_directions(const Eigen::SparseMatrix<double> &stiffness,
                    const int dim,
                    const Eigen::Index v)
    {
      constexpr double rounding = 1e-10;
      const Eigen::MatrixXd own = stiffness.block(dim * v, dim * v, dim, dim);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(own);
      const double largest = eigen.eigenvalues().cwiseAbs().maxCoeff();
      Eigen::Index n       = 0;
      while (n < dim && eigen.eigenvalues()[n] <= rounding * largest &&
             eigen.eigenvalues()[n] >= -rounding * largest)
        ++n;
      return eigen.eigenvectors().leftCols(n);
    }
  } // namespace


  std::vector<unsigned int>
  loose_nodes(const Eigen::SparseMatrix<double> &stiffness, const int dim)
  {
    std::vector<unsigned int> loose;
    for (Eigen::Index v = 0; v < stiffness.cols() / dim; ++v)
      if (free_directions(stiffness, dim, v).cols() > 0)
        loose.push_back(v);
    return loose;
  }


  FreeMotions
  find_free_motions(const Eigen::SparseMatrix<double> &stiffness,
                    const Eigen::MatrixXd &nodes)
  {
    const int dim = nodes.rows();
    const FreeBody body(stiffness, nodes);
    FreeMotions found{body.n_mechanisms(), 0, 0};
    if (found.n == 0)
      return found;

    Eigen::MatrixXd of_nodes(stiffness.rows(), 0);
    for (const unsigned int v : loose_nodes(stiffness, dim))
      {
        const Eigen::MatrixXd directions = free_directions(stiffness, dim, v);
        const Eigen::Index first         = of_nodes.cols();
        of_nodes.conservativeResize(Eigen::NoChange, first + directions.cols());
        of_nodes.rightCols(directions.cols()).setZero();
        of_nodes.block(dim * v, first, dim, directions.cols()) = directions;
      }
    if (found.n <= of_nodes.cols())
      return found;

    found.n_of_parts             = found.n - of_nodes.cols();
    const Eigen::VectorXd motion = body.softest_motion(of_nodes);
    Eigen::Map<const Eigen::MatrixXd>(motion.data(), dim, nodes.cols())
      .colwise()
      .norm()
      .maxCoeff(&found.moved_node);
    return found;
  }
} // namespace springfit
