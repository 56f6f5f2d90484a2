#include <springfit/motion/block_factors.h>

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace springfit
{
  namespace
  {
    using Neighbours = std::vector<std::vector<unsigned int>>;

    /** Nodes in an order that keeps factors sparse. */
    template <typename AreCoupled>
    std::vector<int>
    order_of(const Neighbours &neighbours, const AreCoupled &are_coupled)
    {
      const Eigen::Index n = neighbours.size();
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index v = 0; v < n; ++v)
        for (const unsigned int w : neighbours[v])
          if (are_coupled(v, w))
            entries.emplace_back(w, v, 1.);
      Eigen::SparseMatrix<double> graph(n, n);
      graph.setFromTriplets(entries.begin(), entries.end());
      Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
      Eigen::AMDOrdering<int>()(graph, order);
      return {order.indices().data(), order.indices().data() + n};
    }

    /**
     * The rows of each column of the factors below the diagonal, ascending: a
     * column has those of the matrix and of the columns that it is the first
     * row of (George and Liu 1981).
     */
    std::vector<std::vector<int>>
    rows_of_factors(const std::vector<std::vector<int>> &rows_of_matrix)
    {
      std::vector<std::vector<int>> rows = rows_of_matrix;
      for (std::size_t k = 0; k < rows.size(); ++k)
        {
          std::sort(rows[k].begin(), rows[k].end());
          rows[k].erase(std::unique(rows[k].begin(), rows[k].end()),
                        rows[k].end());
          if (!rows[k].empty())
            rows[rows[k][0]].insert(rows[rows[k][0]].end(),
                                    rows[k].begin() + 1,
                                    rows[k].end());
        }
      return rows;
    }


    template <int dim, typename Number>
    class Factors : public BlockFactors
    {
    public:
      Factors(const NodePattern &pattern, const std::vector<bool> &alone)
      {
        const Neighbours neighbours = pattern.neighbours();
        const int n                 = neighbours.size();
        const auto are_coupled      = [&](const int v, const int w) {
          return v == w || (!alone[v] && !alone[w]);
        };
        node_ = order_of(neighbours, are_coupled);
        std::vector<int> position(n);
        for (int k = 0; k < n; ++k)
          position[node_[k]] = k;

        std::vector<std::vector<int>> rows_of_matrix(n);
        first_source_.push_back(0);
        for (int k = 0; k < n; ++k)
          {
            const auto &of_node = neighbours[node_[k]];
            for (std::size_t e = 0; e < of_node.size(); ++e)
              if (const int row = position[of_node[e]];
                  row >= k && are_coupled(node_[k], of_node[e]))
                {
                  sources_.push_back({row, static_cast<int>(dim * e)});
                  if (row > k)
                    rows_of_matrix[k].push_back(row);
                }
            first_source_.push_back(sources_.size());
          }

        std::vector<std::vector<Eigen::Index>> blocks_of_row(n);
        first_.push_back(0);
        for (const auto &rows : rows_of_factors(rows_of_matrix))
          {
            for (const int row : rows)
              {
                blocks_of_row[row].push_back(row_.size());
                column_.push_back(first_.size() - 1);
                row_.push_back(row);
              }
            first_.push_back(row_.size());
          }
        first_of_row_.push_back(0);
        for (const auto &blocks : blocks_of_row)
          {
            of_row_.insert(of_row_.end(), blocks.begin(), blocks.end());
            first_of_row_.push_back(of_row_.size());
          }
        blocks_.resize(row_.size());
        diagonal_.resize(n);
        pivots_.resize(n);
        work_.assign(n, Padded::Zero());
      }

      void
      factorise(const Eigen::SparseMatrix<double> &matrix) override
      {
        least_pivot_ = std::numeric_limits<Number>::infinity();
        are_there_   = true;
        for (std::size_t k = 0; k < node_.size() && are_there_; ++k)
          {
            take_column(matrix, k);
            for (Eigen::Index r = first_of_row_[k]; r < first_of_row_[k + 1];
                 ++r)
              subtract(of_row_[r]);
            store_column(k);
          }
        if (!are_there_)
          std::fill(work_.begin(), work_.end(), Padded::Zero());
      }

      bool
      exist() const override
      {
        return are_there_;
      }

      bool
      are_positive() const override
      {
        return are_there_ && least_pivot_ > 0.;
      }

      void
      solve(Eigen::MatrixXd &x) const override
      {
        const int n = node_.size();
        std::vector<Column> y(n, Column::Zero());
        for (int k = 0; k < n; ++k)
          {
            y[k].template head<dim>() +=
              x.col(node_[k]).template head<dim>().template cast<Number>();
            for (int a = 0; a < dim; ++a)
              for (int b = 0; b < a; ++b)
                y[k][a] -= diagonal_[k](a, b) * y[k][b];
            for (Eigen::Index q = first_[k]; q < first_[k + 1]; ++q)
              {
                Column &there = y[row_[q]];
                for (int a = 0; a < dim; ++a)
                  there -= y[k][a] * blocks_[q].col(a);
              }
          }
        for (int k = n - 1; k >= 0; --k)
          {
            Vector z    = y[k].template head<dim>().cwiseQuotient(pivots_[k]);
            Padded sums = Padded::Zero();
            for (Eigen::Index q = first_[k]; q < first_[k + 1]; ++q)
              for (int a = 0; a < dim; ++a)
                sums.col(a) += blocks_[q].col(a).cwiseProduct(y[row_[q]]);
            z -= sums.colwise().sum().transpose();
            for (int a = dim - 1; a >= 0; --a)
              for (int b = a + 1; b < dim; ++b)
                z[a] -= diagonal_[k](b, a) * z[b];
            y[k].template head<dim>() = z;
            x.col(node_[k])           = z.template cast<double>();
          }
      }

    private:
      // Rows are processed so many at a time; the last of a block may be 0.
      static constexpr int n_lanes = 16 / sizeof(Number);
      static constexpr int n_rows  = n_lanes * ((dim + n_lanes - 1) / n_lanes);
      using Padded                 = Eigen::Matrix<Number, n_rows, dim>;
      using Column                 = Eigen::Matrix<Number, n_rows, 1>;
      using Block                  = Eigen::Matrix<Number, dim, dim>;
      using Vector                 = Eigen::Matrix<Number, dim, 1>;
      using Lanes                  = Eigen::Matrix<Number, n_lanes, 1>;

      /** Sets the work to column @p k of the matrix. */
      void
      take_column(const Eigen::SparseMatrix<double> &matrix, const int k)
      {
        const int *column    = matrix.outerIndexPtr() + dim * node_[k];
        const double *values = matrix.valuePtr();
        for (Eigen::Index s = first_source_[k]; s < first_source_[k + 1]; ++s)
          for (int a = 0; a < dim; ++a)
            for (int b = 0; b < dim; ++b)
              work_[sources_[s].row](b, a) =
                values[column[a] + sources_[s].entry + b];
      }

      /**
       * Take what the column of the factors' block @p p contributes to the
       * column of the block's row off the work.
       */
      void
      subtract(const Eigen::Index p)
      {
        const int j       = column_[p];
        const Block right = pivots_[j].asDiagonal() *
                            blocks_[p].template topRows<dim>().transpose();
        const Padded *blocks = blocks_.data();
        const int *row       = row_.data();
        Padded *work         = work_.data();
        const auto end       = first_[j + 1];
        for (Eigen::Index q = p; q < end; ++q)
          {
            // Some rows at a time, so that all is in registers.
            const Number *left = blocks[q].data();
            Number *target     = work[row[q]].data();
            for (int h = 0; h < n_rows; h += n_lanes)
              for (int a = 0; a < dim; ++a)
                {
                  Lanes sum = Lanes::MapAligned(target + n_rows * a + h);
                  for (int b = 0; b < dim; ++b)
                    sum -=
                      Lanes::MapAligned(left + n_rows * b + h) * right(b, a);
                  Lanes::MapAligned(target + n_rows * a + h) = sum;
                }
          }
      }

      /** Make the work column @p k of the factors, and 0. */
      void
      store_column(const int k)
      {
        Padded &pivot = work_[k];
        Block &lower  = diagonal_[k];
        for (int a = 0; a < dim; ++a)
          {
            for (int b = 0; b < a; ++b)
              {
                Number value = pivot(a, b);
                for (int c = 0; c < b; ++c)
                  value -= lower(a, c) * pivots_[k][c] * lower(b, c);
                lower(a, b) = value / pivots_[k][b];
              }
            Number value = pivot(a, a);
            for (int c = 0; c < a; ++c)
              value -= lower(a, c) * lower(a, c) * pivots_[k][c];
            pivots_[k][a] = value;
            least_pivot_  = std::min(least_pivot_, value);
            are_there_    = are_there_ && std::isfinite(value) && value != 0.;
          }
        const Vector inverse = pivots_[k].cwiseInverse();
        for (Eigen::Index q = first_[k]; q < first_[k + 1]; ++q)
          {
            Padded &source = work_[row_[q]];
            for (int a = 0; a < dim; ++a)
              for (int b = 0; b < a; ++b)
                source.col(a) -= lower(a, b) * source.col(b);
            for (int a = 0; a < dim; ++a)
              blocks_[q].col(a) = source.col(a) * inverse[a];
            source.setZero();
          }
        pivot.setZero();
      }

      std::vector<int> node_; // by position in the order

      // The blocks of the matrix by the column, a position: the row, and the
      // entry of the node's columns in the matrix where it begins.
      struct Source
      {
        int row, entry;
      };
      std::vector<Source> sources_;
      std::vector<Eigen::Index> first_source_;

      // The blocks of L below the diagonal by the column, and which they are by
      // the row.
      std::vector<int> row_, column_;
      std::vector<Eigen::Index> first_, of_row_, first_of_row_;
      std::vector<Padded, Eigen::aligned_allocator<Padded>> blocks_;

      // Of L, below the diagonal alone, and D.
      std::vector<Block, Eigen::aligned_allocator<Block>> diagonal_;
      std::vector<Vector, Eigen::aligned_allocator<Vector>> pivots_;

      // A column in the making, by the row; 0 between columns.
      std::vector<Padded, Eigen::aligned_allocator<Padded>> work_;

      bool are_there_     = false;
      Number least_pivot_ = 0.;
    };
  } // namespace


  template <typename Number>
  std::unique_ptr<BlockFactors>
  make_block_factors(const int dim,
                     const NodePattern &pattern,
                     const std::vector<bool> &alone)
  {
    if (dim == 2)
      return std::make_unique<Factors<2, Number>>(pattern, alone);
    return std::make_unique<Factors<3, Number>>(pattern, alone);
  }

  template std::unique_ptr<BlockFactors>
  make_block_factors<double>(int,
                             const NodePattern &,
                             const std::vector<bool> &);
  template std::unique_ptr<BlockFactors>
  make_block_factors<float>(int,
                            const NodePattern &,
                            const std::vector<bool> &);
} // namespace springfit
