#ifndef springfit_springs_tangent_matrix_h
#define springfit_springs_tangent_matrix_h

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace springfit
{
  /** Which nodes have entries in common. */
  class NodePattern
  {
  public:
    explicit NodePattern(Eigen::Index n_nodes);

    /** Nodes from @p nodes on, all of which have entries with each other. */
    void
    add_clique(const unsigned int *nodes, std::size_t n);

    /** By node, those that it has entries with, ascending. */
    std::vector<std::vector<unsigned int>>
    neighbours() const;

  private:
    std::vector<std::vector<unsigned int>> neighbours_;
  };


  /**
   * A matrix on the displacements of nodes, in N/m, of a sparsity that is fixed
   * when it is made. Row and column dim * v + d are component d of node v.
   */
  class TangentMatrix
  {
  public:
    TangentMatrix(int dim, const NodePattern &pattern);

    void
    set_zero();

    /** Add a block at the rows of node @p a and the columns of @p b. */
    template <typename Block>
    void
    add(const unsigned int a, const unsigned int b, const Block &block)
    {
      constexpr int dim = Block::RowsAtCompileTime;
      static_assert(dim > 0, "The size of the block is not fixed.");
      const int *column = matrix_.outerIndexPtr() + dim * b;
      const int n       = column[1] - column[0];
      double *entry     = matrix_.valuePtr() + column[0] +
                      first_row(matrix_.innerIndexPtr() + column[0],
                                n / dim,
                                dim,
                                static_cast<int>(dim * a));
      for (int d = 0; d < dim; ++d, entry += n)
        for (int c = 0; c < dim; ++c)
          entry[c] += block(c, d);
    }

    const Eigen::SparseMatrix<double> &
    matrix() const;

    /** All entries of the sparsity, column by column. */
    Eigen::Map<Eigen::VectorXd>
    entries();

    Eigen::Map<const Eigen::VectorXd>
    entries() const;

  private:
    /**
     * Where @p row stands among @p rows, ascending, of which @p n follow each
     * other at the @p stride. A search by halves without branches, which would
     * be foretold wrongly half of the times.
     */
    static int
    first_row(const int *rows, int n, const int stride, const int row)
    {
      int first = 0;
      while (n > 1)
        {
          const int half = n / 2;
          first += rows[stride * half + first] <= row ? stride * half : 0;
          n -= half;
        }
      return first;
    }

    Eigen::SparseMatrix<double> matrix_;
  };
} // namespace springfit

#endif
