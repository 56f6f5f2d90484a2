#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/cell_compliance.h>
#include <springfit/fit/object/compliance.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace springfit
{
  namespace
  {
    ObjectProblem
    as_object(const FitProblem &problem,
              const CellTerms &terms,
              const Eigen::Index n_nonnegative)
    {
      std::vector<unsigned int> nodes(problem.points.cols());
      std::iota(nodes.begin(), nodes.end(), 0);
      ObjectProblem object{problem.points,
                           problem.stiffness.sparseView(),
                           {},
                           std::vector<bool>(terms.norms.size(), false)};
      std::fill_n(object.nonnegative.begin(), n_nonnegative, true);
      for (Eigen::Index t = 0; t < terms.norms.size(); ++t)
        object.terms.push_back(
          {nodes,
           0.,
           {},
           terms.gradients.col(t) * terms.gradients.col(t).transpose()});
      return object;
    }
  } // namespace

  FittedCell
  fit_compliance(const FitProblem &problem, const FitOptions &options)
  {
    return approximate(
      problem,
      options,
      [&problem](const CellTerms &terms, const Eigen::Index n_nonnegative) {
        return FittedCell{make_cell_model(
          terms, fit_compliance(as_object(problem, terms, n_nonnegative)))};
      });
  }
} // namespace springfit
