#include <springfit/motion/multigrid.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    using Sparse       = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    using SingleMatrix = Eigen::SparseMatrix<float, Eigen::RowMajor>;

    // Below this many a dense inverse is cheap.
    constexpr Eigen::Index coarsest = 300;

    // What is weaker joins nothing: of the geometric mean of the largest
    // couplings of both nodes, however many they have, and of sqrt(a_ii a_jj),
    // where the nodes hardly know of each other.
    constexpr double strength = 0.1, least_strength = 1e-3;

    Sparse
    strong_part(const Sparse &A, const Eigen::VectorXd &diagonal)
    {
      Eigen::VectorXd largest = Eigen::VectorXd::Zero(A.rows());
      for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Sparse::InnerIterator entry(A, i); entry; ++entry)
          if (entry.col() != i)
            largest[i] = std::max(largest[i], std::abs(entry.value()));
      Sparse strong = A;
      strong.prune([&](const Eigen::Index i, const Eigen::Index j, double a) {
        const double bound =
          std::max(strength * std::sqrt(largest[i] * largest[j]),
                   least_strength * std::sqrt(diagonal[i] * diagonal[j]));
        return i == j || std::abs(a) > bound;
      });
      return strong;
    }

    // Of a node that is in no aggregate.
    constexpr Eigen::Index none = -1;

    /**
     * The aggregate of each node, and how many there are. Nodes by themselves
     * are in none: relaxing them is exact.
     */
    Eigen::Index
    aggregate(const Sparse &strong, std::vector<Eigen::Index> &aggregate_of)
    {
      const Eigen::Index n   = strong.rows();
      const auto is_isolated = [&](const Eigen::Index i) {
        return strong.outerIndexPtr()[i + 1] - strong.outerIndexPtr()[i] == 1;
      };
      aggregate_of.assign(n, none);
      Eigen::Index n_aggregates = 0;
      // Whole neighbourhoods first,
      for (Eigen::Index i = 0; i < n; ++i)
        {
          bool is_free = !is_isolated(i);
          for (Sparse::InnerIterator entry(strong, i); entry; ++entry)
            is_free = is_free && aggregate_of[entry.col()] == none;
          if (!is_free)
            continue;
          for (Sparse::InnerIterator entry(strong, i); entry; ++entry)
            aggregate_of[entry.col()] = n_aggregates;
          ++n_aggregates;
        }
      // then what is left joins the strongest of them. A node has a neighbour
      // in one, or its own neighbourhood would be one.
      const std::vector<Eigen::Index> whole = aggregate_of;
      for (Eigen::Index i = 0; i < n; ++i)
        if (aggregate_of[i] == none)
          {
            double largest = -1.;
            for (Sparse::InnerIterator entry(strong, i); entry; ++entry)
              if (whole[entry.col()] != none &&
                  std::abs(entry.value()) > largest)
                {
                  largest         = std::abs(entry.value());
                  aggregate_of[i] = whole[entry.col()];
                }
          }
      return n_aggregates;
    }

    /** An estimate of the largest eigenvalue of D^-1 A, from above in effect.
     */
    double
    largest_eigenvalue(const Sparse &A, const Eigen::VectorXd &diagonal)
    {
      // Gershgorin's circles bound it.
      double largest = 0.;
      for (Eigen::Index i = 0; i < A.rows(); ++i)
        {
          double sum = 0.;
          for (Sparse::InnerIterator entry(A, i); entry; ++entry)
            sum += std::abs(entry.value());
          largest = std::max(largest, sum / diagonal[i]);
        }
      return largest;
    }

    /** Constants on aggregates, smoothed by a step of Jacobi's method. */
    Sparse
    prolongation_of(const Sparse &A)
    {
      const Eigen::VectorXd diagonal = A.diagonal();
      std::vector<Eigen::Index> aggregate_of;
      const Eigen::Index n_coarse =
        aggregate(strong_part(A, diagonal), aggregate_of);
      Sparse tentative(A.rows(), n_coarse);
      tentative.reserve(Eigen::VectorXi::Ones(A.rows()));
      for (Eigen::Index i = 0; i < A.rows(); ++i)
        if (aggregate_of[i] != none)
          tentative.insert(i, aggregate_of[i]) = 1.;
      tentative.makeCompressed();
      const double omega = 4. / (3. * largest_eigenvalue(A, diagonal));
      Sparse smoothed    = A * tentative;
      for (Eigen::Index i = 0; i < smoothed.rows(); ++i)
        for (Sparse::InnerIterator entry(smoothed, i); entry; ++entry)
          entry.valueRef() *= omega / diagonal[i];
      return tentative - smoothed;
    }

    /** Of each row's entry on the diagonal among all entries. */
    std::vector<int>
    diagonal_positions(const SingleMatrix &A)
    {
      std::vector<int> positions;
      for (Eigen::Index i = 0; i < A.rows(); ++i)
        {
          const int *row = A.innerIndexPtr();
          positions.push_back(std::lower_bound(row + A.outerIndexPtr()[i],
                                               row + A.outerIndexPtr()[i + 1],
                                               static_cast<int>(i)) -
                              row);
        }
      return positions;
    }

    /**
     * The entries from @p begin to @p end of a row times vectors. Four sums at
     * once: an addition need not wait for the one before.
     */
    [[gnu::always_inline]] inline Eigen::Vector4f
    row_product(const SingleMatrix &A,
                const int begin,
                const int end,
                const Eigen::Matrix<float, 4, Eigen::Dynamic> &x)
    {
      const float *values    = A.valuePtr();
      const int *columns     = A.innerIndexPtr();
      Eigen::Vector4f sum[4] = {Eigen::Vector4f::Zero(),
                                Eigen::Vector4f::Zero(),
                                Eigen::Vector4f::Zero(),
                                Eigen::Vector4f::Zero()};
      int k                  = begin;
      for (; k + 4 <= end; k += 4)
        for (int l = 0; l < 4; ++l)
          sum[l] += values[k + l] * x.col(columns[k + l]);
      for (; k < end; ++k)
        sum[0] += values[k] * x.col(columns[k]);
      return (sum[0] + sum[1]) + (sum[2] + sum[3]);
    }
  } // namespace


  Multigrid::Multigrid(const Eigen::SparseMatrix<double> &matrix)
  {
    Sparse A = matrix;
    while (true)
      {
        Level level;
        const Eigen::VectorXd diagonal = A.diagonal();
        if (!(diagonal.minCoeff() > 0.))
          throw std::logic_error("the diagonal is not positive");
        level.matrix           = A.cast<float>();
        level.inverse_diagonal = diagonal.cwiseInverse().cast<float>();
        level.x = level.b = level.r = Vectors::Zero(4, A.rows());
        level.diagonal              = diagonal_positions(level.matrix);
        if (A.rows() <= coarsest)
          {
            levels_.push_back(std::move(level));
            break;
          }
        const Sparse P = prolongation_of(A);
        if (P.cols() == 0 || P.cols() >= A.rows())
          {
            levels_.push_back(std::move(level)); // nothing is connected
            break;
          }
        level.prolongation = P.cast<float>();
        level.restriction  = Matrix(level.prolongation.transpose());
        levels_.push_back(std::move(level));
        A = Sparse(P.transpose()) * Sparse(A * P);
      }
    if (A.rows() <= coarsest)
      coarse_inverse_ = Eigen::LLT<Eigen::MatrixXd>(Eigen::MatrixXd(A))
                          .solve(Eigen::MatrixXd::Identity(A.rows(), A.rows()))
                          .cast<float>();
  }


  void
  Multigrid::apply(const Eigen::MatrixXd &forces, Eigen::MatrixXd &result)
  {
    Level &finest                   = levels_.front();
    finest.b.topRows(forces.rows()) = forces.cast<float>();
    cycle(0);
    result = finest.x.topRows(forces.rows()).cast<double>();
  }


  std::vector<Eigen::Index>
  Multigrid::sizes() const
  {
    std::vector<Eigen::Index> sizes;
    for (const Level &level : levels_)
      sizes.push_back(level.matrix.rows());
    return sizes;
  }


  double
  Multigrid::operator_complexity() const
  {
    double sum = 0.;
    for (const Level &level : levels_)
      sum += level.matrix.nonZeros();
    return sum / levels_.front().matrix.nonZeros();
  }


  void
  Multigrid::cycle(const std::size_t l)
  {
    Level &level = levels_[l];
    if (l + 1 == levels_.size())
      {
        if (coarse_inverse_.size() > 0)
          level.x.noalias() = level.b * coarse_inverse_;
        else
          level.x = level.b * level.inverse_diagonal.asDiagonal();
        return;
      }

    const Matrix &A      = level.matrix;
    const Eigen::Index n = A.rows();
    const int *rows      = A.outerIndexPtr();

    // Forwards from zero: what is behind the diagonal does not count yet, and
    // is what is left over in the end.
    const std::vector<int> &diagonal = level.diagonal;
    for (Eigen::Index i = 0; i < n; ++i)
      level.x.col(i) =
        level.inverse_diagonal[i] *
        (level.b.col(i) - row_product(A, rows[i], diagonal[i], level.x));
    for (Eigen::Index i = 0; i < n; ++i)
      level.r.col(i) = -row_product(A, diagonal[i] + 1, rows[i + 1], level.x);

    Level &next       = levels_[l + 1];
    const Matrix &R   = level.restriction;
    const int *coarse = R.outerIndexPtr();
    for (Eigen::Index i = 0; i < R.rows(); ++i)
      next.b.col(i) = row_product(R, coarse[i], coarse[i + 1], level.r);
    cycle(l + 1);
    const Matrix &P = level.prolongation;
    const int *fine = P.outerIndexPtr();
    for (Eigen::Index i = 0; i < n; ++i)
      level.x.col(i) += row_product(P, fine[i], fine[i + 1], next.x);
    for (Eigen::Index i = n - 1; i >= 0; --i)
      level.x.col(i) +=
        level.inverse_diagonal[i] *
        (level.b.col(i) - row_product(A, rows[i], rows[i + 1], level.x));
  }
} // namespace springfit
