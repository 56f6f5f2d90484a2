#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/cell/several_states.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>

namespace springfit
{
  Eigen::MatrixXd
  tangent_gram(const Eigen::MatrixXd &B)
  {
    return (B.transpose() * B).cwiseAbs2();
  }


  Eigen::VectorXd
  tangent_products(const Eigen::MatrixXd &B, const Eigen::MatrixXd &R)
  {
    return B.cwiseProduct(R * B).colwise().sum();
  }


  Eigen::VectorXd
  fit_frobenius(const Eigen::MatrixXd &B,
                const Eigen::MatrixXd &R,
                const Eigen::Index n_nonnegative)
  {
    return nonnegative_least_squares(tangent_gram(B),
                                     tangent_products(B, R),
                                     n_nonnegative);
  }


  FittedCell
  fit_frobenius(const FitProblem &problem, const FitOptions &options)
  {
    if (!problem.states.empty())
      return fit_states(problem, options);
    return approximate(
      problem,
      options,
      [&problem](const CellTerms &terms, const Eigen::Index n_nonnegative) {
        return FittedCell{make_cell_model(
          terms,
          fit_frobenius(terms.gradients, problem.stiffness, n_nonnegative))};
      });
  }
} // namespace springfit
