#include <springfit/fit/cell/approximation.h>
#include <springfit/fit/cell/block.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>

namespace springfit
{
  Eigen::VectorXd
  fit_block(const Eigen::MatrixXd &B,
            const Eigen::MatrixXd &R,
            const Eigen::Index dim,
            const Eigen::Index n_nonnegative)
  {
    // All blocks without those on the diagonal.
    Eigen::MatrixXd gram     = tangent_gram(B);
    Eigen::VectorXd products = tangent_products(B, R);
    for (Eigen::Index row = 0; row < B.rows(); row += dim)
      {
        const Eigen::MatrixXd B_node = B.middleRows(row, dim);
        gram -= tangent_gram(B_node);
        products -= tangent_products(B_node, R.block(row, row, dim, dim));
      }
    return nonnegative_least_squares(gram, products, n_nonnegative);
  }


  FittedCell
  fit_block(const FitProblem &problem, const FitOptions &options)
  {
    return approximate(
      problem,
      options,
      [&problem](const CellTerms &terms, const Eigen::Index n_nonnegative) {
        return FittedCell{make_cell_model(terms,
                                          fit_block(terms.gradients,
                                                    problem.stiffness,
                                                    problem.points.rows(),
                                                    n_nonnegative))};
      });
  }
} // namespace springfit
