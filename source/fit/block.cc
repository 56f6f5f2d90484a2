#include <springfit/fit/block.h>

namespace springfit
{
  Eigen::VectorXd
  fit_block(const FitProblem &problem)
  {
    const Eigen::Index dim = problem.points.rows();
    Eigen::VectorXd k(problem.springs.size());
    for (Eigen::Index s = 0; s < k.size(); ++s)
      {
        const auto [i, j] = problem.springs[s];
        const auto b      = problem.gradients.col(s);
        double n_R_n      = 0.;
        for (Eigen::Index d = 0; d < dim; ++d)
          for (Eigen::Index c = 0; c < dim; ++c)
            n_R_n += b[dim * j + c] *
                     problem.stiffness(dim * i + c, dim * j + d) *
                     b[dim * j + d];
        k[s] = -n_R_n;
      }
    return k;
  }


  Eigen::VectorXd
  fit_block_nonnegative(const FitProblem &problem)
  {
    return fit_block(problem).cwiseMax(0.);
  }
} // namespace springfit
