#include <springfit/response/network_body.h>
#include <springfit/response/stability.h>

#include <Eigen/SparseCholesky>

#include <cmath>

namespace springfit
{
  namespace
  {
    using SparseMatrix = Eigen::SparseMatrix<double>;

    /** The rows and columns of what is not held. */
    SparseMatrix
    free_part(const SparseMatrix &matrix, const std::vector<bool> &held)
    {
      Eigen::Index n_unknowns = 0;
      std::vector<Eigen::Index> unknown(matrix.rows(), -1);
      for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        if (!held[row])
          unknown[row] = n_unknowns++;

      std::vector<Eigen::Triplet<double>> entries;
      entries.reserve(matrix.nonZeros());
      for (Eigen::Index column = 0; column < matrix.cols(); ++column)
        for (SparseMatrix::InnerIterator it(matrix, column); it; ++it)
          if (unknown[it.row()] >= 0 && unknown[it.col()] >= 0)
            entries.emplace_back(unknown[it.row()],
                                 unknown[it.col()],
                                 it.value());
      SparseMatrix part(n_unknowns, n_unknowns);
      part.setFromTriplets(entries.begin(), entries.end());
      return part;
    }
  } // namespace

  unsigned int
  n_unstable_motions(const ElasticBody &body,
                     const Eigen::MatrixXd &displacement,
                     const std::vector<bool> &held)
  {
    if (!std::isfinite(body.energy(displacement)))
      return 1; // no state at all
    NodePattern pattern(displacement.cols());
    body.add_to_pattern(pattern);
    TangentMatrix tangent(displacement.rows(), pattern);
    body.add_tangent(displacement, tangent);

    const Eigen::SimplicialLDLT<SparseMatrix> factors(
      free_part(tangent.matrix(), held));
    if (factors.info() != Eigen::Success)
      return 1; // a pivot vanished
    return (factors.vectorD().array() <= 0.).count();
  }

  std::optional<unsigned int>
  n_unstable_at_rest(const SpringNetwork &network,
                     const std::vector<bool> &held)
  {
    if (n_negative(network.families) == 0 &&
        has_springs_alone(network.families))
      return 0;
    const Eigen::Index dim        = network.nodes.rows();
    const Eigen::Index most_nodes = dim == 2 ? 50000 : 5000;
    if (network.nodes.cols() > most_nodes)
      return {};
    return n_unstable_motions(NetworkBody(network),
                              Eigen::MatrixXd::Zero(dim, network.nodes.cols()),
                              held);
  }
} // namespace springfit
