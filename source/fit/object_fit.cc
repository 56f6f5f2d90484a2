#include <springfit/fit/object_fit.h>
#include <springfit/fit/quadratic_program.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  namespace
  {
    using SparseMatrix = Eigen::SparseMatrix<double>;
    using Triplets     = std::vector<Eigen::Triplet<double>>;

    /** The entries of the lower triangles of R and of all tangents, numbered.
     */
    class LowerEntries
    {
    public:
      explicit LowerEntries(const ObjectProblem &problem)
        : pattern_(problem.stiffness.rows(), problem.stiffness.cols())
      {
        Triplets entries;
        const auto add = [&](const Eigen::Index row,
                             const Eigen::Index column) {
          if (row >= column)
            entries.emplace_back(row, column, 1.);
        };
        for (Eigen::Index column = 0; column < pattern_.cols(); ++column)
          for (SparseMatrix::InnerIterator it(problem.stiffness, column); it;
               ++it)
            add(it.row(), it.col());
        for (const auto &term : problem.terms)
          for (const auto &entry : tangent_entries(term))
            add(entry.row, entry.column);
        pattern_.setFromTriplets(entries.begin(), entries.end());
      }

      Eigen::Index
      size() const
      {
        return pattern_.nonZeros();
      }

      Eigen::Index
      number(const Eigen::Index row, const Eigen::Index column) const
      {
        const auto *rows  = pattern_.innerIndexPtr();
        const auto *first = pattern_.outerIndexPtr() + column;
        return std::lower_bound(rows + first[0], rows + first[1], row) - rows;
      }

    private:
      SparseMatrix pattern_;
    };
  } // namespace

  LinearEquations
  matrix_equations(const ObjectProblem &problem)
  {
    const LowerEntries lower(problem);
    const SparseMatrix &R = problem.stiffness;
    // An entry off the diagonal stands for two.
    const double on_diagonal  = 1. / R.norm();
    const double off_diagonal = std::sqrt(2.) * on_diagonal;
    const auto weight         = [&](const auto row, const auto column) {
      return row == column ? on_diagonal : off_diagonal;
    };

    Eigen::VectorXd d = Eigen::VectorXd::Zero(lower.size());
    for (Eigen::Index column = 0; column < R.cols(); ++column)
      for (SparseMatrix::InnerIterator it(R, column); it; ++it)
        if (it.row() >= it.col())
          d[lower.number(it.row(), it.col())] =
            weight(it.row(), it.col()) * it.value();

    Triplets entries;
    for (std::size_t m = 0; m < problem.terms.size(); ++m)
      for (const auto &[row, column, value] : tangent_entries(problem.terms[m]))
        if (row >= column)
          entries.emplace_back(lower.number(row, column),
                               m,
                               weight(row, column) * value);
    SparseMatrix A(lower.size(), problem.terms.size());
    A.setFromTriplets(entries.begin(), entries.end());
    return {A, d};
  }

  LinearEquations
  force_equations(const ObjectProblem &problem, const Eigen::MatrixXd &fields)
  {
    const Eigen::MatrixXd forces = problem.stiffness * fields;
    const double rounding        = 1e-12 * problem.stiffness.norm();
    const Eigen::Index n         = forces.rows();

    Triplets entries;
    Eigen::VectorXd d(forces.size());
    Eigen::Index n_equations = 0;
    for (Eigen::Index f = 0; f < fields.cols(); ++f)
      {
        const double size = forces.col(f).norm();
        if (!(size > rounding * fields.col(f).norm()))
          continue;
        d.segment(n_equations, n) = forces.col(f) / size;
        for (std::size_t m = 0; m < problem.terms.size(); ++m)
          for (const auto &[row, column, value] :
               tangent_entries(problem.terms[m]))
            entries.emplace_back(n_equations + row,
                                 m,
                                 value * fields(column, f) / size);
        n_equations += n;
      }
    SparseMatrix A(n_equations, problem.terms.size());
    A.setFromTriplets(entries.begin(), entries.end());
    return {A, d.head(n_equations)};
  }

  Eigen::VectorXd
  fit_matrix(const ObjectProblem &problem)
  {
    const auto [A, d] = matrix_equations(problem);
    return minimise_quadratic(SparseMatrix(A.transpose() * A),
                              A.transpose() * d,
                              problem.nonnegative);
  }

  Eigen::VectorXd
  fit_forces(const ObjectProblem &problem,
             const Eigen::MatrixXd &fields,
             const Eigen::VectorXd &prior,
             const double prior_weight)
  {
    const auto forces = force_equations(problem, fields);
    const auto matrix = matrix_equations(problem);
    const double w    = prior_weight * prior_weight;

    const SparseMatrix G_matrix = matrix.A.transpose() * matrix.A;
    const SparseMatrix G =
      SparseMatrix(forces.A.transpose() * forces.A) + w * G_matrix;
    const Eigen::VectorXd g =
      forces.A.transpose() * forces.d + w * (G_matrix * prior);
    return minimise_quadratic(G, g, problem.nonnegative);
  }
} // namespace springfit
