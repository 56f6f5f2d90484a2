#include <springfit/response/stability.h>

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace springfit
{
  unsigned int
  n_unstable_motions(const SpringNetwork &network,
                     const std::vector<bool> &fixed)
  {
    const Eigen::Index dim = network.nodes.rows();
    std::vector<Eigen::Index> first_unknown(fixed.size(), -1);
    Eigen::Index n_unknowns = 0;
    for (std::size_t node = 0; node < fixed.size(); ++node)
      if (!fixed[node])
        {
          first_unknown[node] = n_unknowns;
          n_unknowns += dim;
        }

    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t s = 0; s < network.stiffness.size(); ++s)
      {
        const unsigned int ends[2] = {network.i[s], network.j[s]};
        const Eigen::VectorXd n =
          (network.nodes.col(ends[1]) - network.nodes.col(ends[0]))
            .normalized();
        for (const int a : {0, 1})
          for (const int b : {0, 1})
            if (const auto row = first_unknown[ends[a]],
                column         = first_unknown[ends[b]];
                row >= 0 && column >= 0)
              for (Eigen::Index d = 0; d < dim; ++d)
                for (Eigen::Index e = 0; e < dim; ++e)
                  entries.emplace_back(row + d,
                                       column + e,
                                       (a == b ? 1. : -1.) *
                                         network.stiffness[s] * n[d] * n[e]);
      }
    Eigen::SparseMatrix<double> tangent(n_unknowns, n_unknowns);
    tangent.setFromTriplets(entries.begin(), entries.end());

    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(tangent);
    if (factors.info() != Eigen::Success)
      return 1; // a pivot vanished
    return (factors.vectorD().array() <= 0.).count();
  }
} // namespace springfit
