#include <springfit/response/stability.h>

#include <Eigen/SparseCholesky>

namespace springfit
{
  unsigned int
  n_unstable_motions(const ElasticBody &body,
                     const Eigen::MatrixXd &displacement,
                     const std::vector<bool> &fixed)
  {
    const Eigen::Index dim = displacement.rows();
    std::vector<Eigen::Index> first_unknown(fixed.size(), -1);
    Eigen::Index n_unknowns = 0;
    for (std::size_t node = 0; node < fixed.size(); ++node)
      if (!fixed[node])
        {
          first_unknown[node] = n_unknowns;
          n_unknowns += dim;
        }

    Eigen::SparseMatrix<double> tangent(n_unknowns, n_unknowns);
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int t = 0; t < body.n_terms(); ++t)
      {
        const auto term = body.evaluate(t, displacement);
        if (!term)
          return 1; // no state at all
        for (std::size_t a = 0; a < term->nodes.size(); ++a)
          for (std::size_t b = 0; b < term->nodes.size(); ++b)
            if (const auto row = first_unknown[term->nodes[a]],
                column         = first_unknown[term->nodes[b]];
                row >= 0 && column >= 0)
              for (Eigen::Index d = 0; d < dim; ++d)
                for (Eigen::Index e = 0; e < dim; ++e)
                  entries.emplace_back(row + d,
                                       column + e,
                                       term->hessian(dim * a + d, dim * b + e));
      }
    tangent.setFromTriplets(entries.begin(), entries.end());

    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(tangent);
    if (factors.info() != Eigen::Success)
      return 1; // a pivot vanished
    return (factors.vectorD().array() <= 0.).count();
  }
} // namespace springfit
