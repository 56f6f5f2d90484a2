#include <springfit/fit/object/free_body.h>
#include <springfit/fit/object/object_fit.h>
#include <springfit/fit/programs/bounded_least_squares.h>
#include <springfit/fit/programs/quadratic_program.h>

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

    Eigen::VectorXd
    flat(const Eigen::MatrixXd &columns)
    {
      return Eigen::Map<const Eigen::VectorXd>(columns.data(), columns.size());
    }

    Eigen::MatrixXd
    as_columns(const Eigen::VectorXd &flat, const Eigen::Index n_rows)
    {
      return Eigen::Map<const Eigen::MatrixXd>(flat.data(),
                                               n_rows,
                                               flat.size() / n_rows);
    }

    /**
     * The fields without rigid motions, those that are none, so that the
     * squares of all norms are equal and add up to one.
     */
    Eigen::MatrixXd
    unit_deformations(const FreeBody &body, const Eigen::MatrixXd &fields)
    {
      Eigen::MatrixXd u = body.deformation(fields);
      Eigen::Index n    = 0;
      for (Eigen::Index f = 0; f < u.cols(); ++f)
        if (u.col(f).norm() > 1e-10 * fields.col(f).norm())
          u.col(n++) = u.col(f).normalized();
      return u.leftCols(n) / std::sqrt(n);
    }

    /** T_m u as column m, one field u below the other. */
    SparseMatrix
    forces_of_terms(const ObjectProblem &problem, const Eigen::MatrixXd &fields)
    {
      Triplets entries;
      for (Eigen::Index f = 0; f < fields.cols(); ++f)
        for (std::size_t m = 0; m < problem.terms.size(); ++m)
          for (const auto &[row, column, value] :
               tangent_entries(problem.terms[m]))
            entries.emplace_back(f * fields.rows() + row,
                                 m,
                                 value * fields(column, f));
      SparseMatrix forces(fields.size(), problem.terms.size());
      forces.setFromTriplets(entries.begin(), entries.end());
      return forces;
    }

    /** s_m, see fit_displacements(). */
    Eigen::VectorXd
    typical_constants(const ObjectProblem &problem)
    {
      const Eigen::Index dim = problem.nodes.rows();
      const Eigen::VectorXd of_nodes =
        as_columns(problem.stiffness.diagonal(), dim).colwise().mean();
      Eigen::VectorXd constants(problem.terms.size());
      for (Eigen::Index m = 0; m < constants.size(); ++m)
        {
          const auto &[nodes, energy, gradient, hessian] = problem.terms[m];
          constants[m] = of_nodes(nodes).mean() / hessian.norm();
        }
      return constants;
    }
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

  Eigen::VectorXd
  fit_matrix(const ObjectProblem &problem)
  {
    const auto [A, d] = matrix_equations(problem);
    return minimise_quadratic(SparseMatrix(A.transpose() * A),
                              A.transpose() * d,
                              problem.nonnegative);
  }

  Eigen::VectorXd
  fit_displacements(const ObjectProblem &problem,
                    const Eigen::MatrixXd &fields,
                    const Eigen::VectorXd &prior,
                    const double prior_weight)
  {
    const FreeBody body(problem.stiffness, problem.nodes);
    const Eigen::MatrixXd u       = unit_deformations(body, fields);
    const SparseMatrix forces     = forces_of_terms(problem, u);
    const SparseMatrix transposed = forces.transpose();
    const auto respond            = [&](const Eigen::VectorXd &f) {
      const Eigen::MatrixXd response = body.respond(as_columns(f, u.rows()));
      return flat(response);
    };

    // R^+ K(c) u for all fields u
    const LinearMap displacements{[&](const Eigen::VectorXd &c) {
                                    return respond(forces * c);
                                  },
                                  [&](const Eigen::VectorXd &y) {
                                    return Eigen::VectorXd(transposed *
                                                           respond(y));
                                  }};
    const double n_terms = problem.terms.size();
    return bounded_least_squares(displacements,
                                 flat(u), // R^+ R u
                                 prior,
                                 std::sqrt(n_terms) / prior_weight *
                                   typical_constants(problem),
                                 problem.nonnegative);
  }
} // namespace springfit
