#include <springfit/fit/object/object_problem.h>

namespace springfit
{
  std::vector<TangentEntry>
  tangent_entries(const EnergyTerm &term)
  {
    const Eigen::Index dim = term.hessian.rows() / term.nodes.size();
    const auto dof         = [&](const Eigen::Index local) {
      return dim * term.nodes[local / dim] + local % dim;
    };
    std::vector<TangentEntry> entries;
    entries.reserve(term.hessian.size());
    for (Eigen::Index b = 0; b < term.hessian.cols(); ++b)
      for (Eigen::Index a = 0; a < term.hessian.rows(); ++a)
        entries.push_back({dof(a), dof(b), term.hessian(a, b)});
    return entries;
  }

  Eigen::SparseMatrix<double>
  fitted_stiffness(const ObjectProblem &problem,
                   const Eigen::VectorXd &constants)
  {
    std::vector<Eigen::Triplet<double>> triplets;
    for (std::size_t m = 0; m < problem.terms.size(); ++m)
      for (const auto &[row, column, value] : tangent_entries(problem.terms[m]))
        triplets.emplace_back(row, column, constants[m] * value);
    Eigen::SparseMatrix<double> K(problem.stiffness.rows(),
                                  problem.stiffness.cols());
    K.setFromTriplets(triplets.begin(), triplets.end());
    return K;
  }
} // namespace springfit
