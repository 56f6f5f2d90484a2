#include <springfit/springs/assembled_operator.h>

#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    /** Adds a symmetric matrix of a TangentMatrix times @p u. */
    template <int dim>
    void
    add_symmetric_product(const Eigen::SparseMatrix<double> &matrix,
                          const Eigen::MatrixXd &u,
                          Eigen::MatrixXd &product)
    {
      using Rows = Eigen::Map<const Eigen::VectorXd>;
      Eigen::VectorXd of_neighbours(matrix.cols());
      for (Eigen::Index v = 0; v < u.cols(); ++v)
        {
          // The columns of a node have the same rows, those of a node in a row.
          const int *column = matrix.outerIndexPtr() + dim * v;
          const int n       = column[1] - column[0];
          const int *rows   = matrix.innerIndexPtr() + column[0];
          for (int i = 0; i < n; i += dim)
            for (int d = 0; d < dim; ++d)
              of_neighbours[i + d] = u.data()[rows[i] + d];
          for (int d = 0; d < dim; ++d)
            product.data()[dim * v + d] +=
              Rows(matrix.valuePtr() + column[d], n).dot(of_neighbours.head(n));
        }
    }
  } // namespace


  AssembledOperator::AssembledOperator(
    std::function<void(NodePattern &)> add_to_pattern,
    std::function<void(const Eigen::MatrixXd &, TangentMatrix &)> add_hessian)
    : add_to_pattern_(std::move(add_to_pattern))
    , add_hessian_(std::move(add_hessian))
  {}


  void
  AssembledOperator::linearise(const Eigen::MatrixXd &state)
  {
    if (!matrix_)
      {
        NodePattern pattern(state.cols());
        add_to_pattern_(pattern);
        matrix_.emplace(state.rows(), pattern);
      }
    matrix_->set_zero();
    add_hessian_(state, *matrix_);
  }


  void
  AssembledOperator::add_product(const Eigen::MatrixXd &u,
                                 Eigen::MatrixXd &product) const
  {
    if (u.rows() == 2)
      add_symmetric_product<2>(matrix_->matrix(), u, product);
    else
      add_symmetric_product<3>(matrix_->matrix(), u, product);
  }
} // namespace springfit
