#ifndef springfit_motion_multigrid_h
#define springfit_motion_multigrid_h

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace springfit
{
  /**
   * An approximate inverse of a symmetric positive definite matrix on nodes,
   * applied to all components of a motion at once: a V cycle of smoothed
   * aggregation (Vanek, Mandel and Brezina 1996) with a sweep of Gauss and
   * Seidel forwards before and backwards after, which makes it symmetric. In
   * single precision, as a preconditioner for a method in double.
   */
  class Multigrid
  {
  public:
    /**
     * @param matrix n_nodes x n_nodes; rows without entries beside the diagonal
     * are nodes by themselves
     *
     * @throws std::logic_error when a diagonal entry is not positive
     */
    explicit Multigrid(const Eigen::SparseMatrix<double> &matrix);

    /** @p result (dim x n_nodes) of @p forces (as it). */
    void
    apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &result);

    /** Of the finest one first. */
    std::vector<Eigen::Index>
    sizes() const;

    /** The entries of all levels relative to those of the finest. */
    double
    operator_complexity() const;

  private:
    using Matrix = Eigen::SparseMatrix<float, Eigen::RowMajor>;

    /** Four components of a node in a register; the last is 0 in space. */
    using Vectors = Eigen::Matrix<float, 4, Eigen::Dynamic>;

    struct Level
    {
      Matrix matrix;
      std::vector<int> diagonal; // where each row's entry is
      Eigen::VectorXf inverse_diagonal;
      Matrix prolongation; // from the next one
      Matrix restriction;  // its transpose
      Vectors x, b, r;
    };

    void
    cycle(std::size_t level);

    std::vector<Level> levels_;
    Eigen::MatrixXf coarse_inverse_;
  };
} // namespace springfit

#endif
