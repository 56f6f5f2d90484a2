#include <springfit/core/error.h>
#include <springfit/fit/programs/ipopt_quadratic.h>
#include <springfit/fit/programs/quadratic_program.h>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace springfit
{
  namespace
  {
    using SparseMatrix = Eigen::SparseMatrix<double>;
    using Flags        = std::vector<bool>;

    constexpr double ridge = 1e-10; // see the header

    /**
     * What optimality_gap() may reach: well above the rounding errors of
     * max|g| = 1, and those of G x, some thousand times the last digit of the
     * products, of which the largest are max|x|: the diagonal of G is one. The
     * second summand rules where G is nearly singular, as in flat cells.
     */
    double
    largest_gap(const Eigen::VectorXd &x)
    {
      return 1e-8 + 1e-12 * x.lpNorm<Eigen::Infinity>();
    }

    RunError
    not_positive()
    {
      return RunError("The equations of the fit are not positive definite.",
                      "Improve the mesh: a cell may be flat.");
    }

    Eigen::VectorXd
    diagonal_of(const SparseMatrix &G)
    {
      return G.diagonal();
    }

    Eigen::VectorXd
    diagonal_of(const Eigen::MatrixXd &G)
    {
      return G.diagonal();
    }

    /** Solves G x = r with x = 0 where @p is_zero. */
    class SparseSolver
    {
    public:
      SparseSolver(SparseMatrix G, const Flags &is_zero) : is_zero_(is_zero)
      {
        G.prune([&](const Eigen::Index row, const Eigen::Index column, double) {
          return row == column || (!is_zero[row] && !is_zero[column]);
        });
        G.diagonal().array() += ridge;
        factors_.compute(G);
        if (factors_.info() != Eigen::Success)
          throw not_positive();
      }

      Eigen::VectorXd
      solve(Eigen::VectorXd r) const
      {
        for (Eigen::Index s = 0; s < r.size(); ++s)
          if (is_zero_[s])
            r[s] = 0.;
        return factors_.solve(r);
      }

    private:
      const Flags is_zero_;
      Eigen::SimplicialLDLT<SparseMatrix> factors_;
    };

    class DenseSolver
    {
    public:
      DenseSolver(const Eigen::MatrixXd &G, const Flags &is_zero)
      {
        for (Eigen::Index s = 0; s < G.cols(); ++s)
          if (!is_zero[s])
            free_.push_back(s);
        G_free_ = G(free_, free_);
        G_free_.diagonal().array() += ridge;
        factors_.emplace(G_free_);
        if (factors_->info() != Eigen::Success)
          throw not_positive();
      }

      DenseSolver(const DenseSolver &) = delete; // the factors refer to it

      Eigen::VectorXd
      solve(const Eigen::VectorXd &r) const
      {
        const Eigen::VectorXd r_free = r(free_);
        const Eigen::VectorXd x_free = factors_->solve(r_free);
        Eigen::VectorXd x            = Eigen::VectorXd::Zero(r.size());
        x(free_)                     = x_free;
        return x;
      }

    private:
      std::vector<Eigen::Index> free_;
      Eigen::MatrixXd G_free_; // overwritten by its factors
      std::optional<Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>> factors_;
    };

    SparseSolver
    make_solver(const SparseMatrix &G, const Flags &is_zero)
    {
      return {G, is_zero};
    }

    DenseSolver
    make_solver(const Eigen::MatrixXd &G, const Flags &is_zero)
    {
      return {G, is_zero};
    }

    SparseMatrix
    to_sparse(const SparseMatrix &G)
    {
      return G;
    }

    SparseMatrix
    to_sparse(const Eigen::MatrixXd &G)
    {
      return G.sparseView();
    }

    /** A program whose matrix has a diagonal of ones, and max|g| = 1. */
    template <typename Matrix>
    struct UnitProgram
    {
      Matrix G;
      Eigen::VectorXd g;
      const Flags &nonnegative;
    };

    /**
     * How far @p x is from the conditions of Karush, Kuhn and Tucker, 0 for
     * the minimiser: the largest derivative, of bounded variables the largest
     * |min(x, derivative)|.
     */
    template <typename Matrix>
    double
    optimality_gap(const UnitProgram<Matrix> &program, const Eigen::VectorXd &x)
    {
      const Eigen::VectorXd derivative = program.G * x - program.g;
      double gap                       = 0.;
      for (Eigen::Index s = 0; s < x.size(); ++s)
        {
          const double miss =
            std::abs(program.nonnegative[s] ? std::min(x[s], derivative[s])
                                            : derivative[s]);
          // Not std::max, which may lose a value that is not a number.
          gap = miss <= gap ? gap : miss;
        }
      return gap;
    }

    /** The minimiser with x = 0 where @p is_zero and no other bounds. */
    template <typename Matrix>
    Eigen::VectorXd
    solve_equations(const UnitProgram<Matrix> &program, const Flags &is_zero)
    {
      const auto solver = make_solver(program.G, is_zero);
      Eigen::VectorXd x = solver.solve(program.g);
      // Corrects rounding errors and what the ridge has changed; that takes
      // more steps where G is nearly singular.
      for (int step = 0; step < 20; ++step)
        {
          const Eigen::VectorXd correction =
            solver.solve(program.g - program.G * x);
          x += correction;
          if (step >= 2 && !(correction.norm() > 1e-6 * x.norm()))
            break;
        }
      return x;
    }

    /** The primal-dual active set method, or nothing where it cycles. */
    template <typename Matrix>
    std::optional<Eigen::VectorXd>
    settle_bounds(const UnitProgram<Matrix> &program, Eigen::VectorXd x)
    {
      Flags is_zero;
      for (int step = 0; step < 30; ++step)
        {
          const Eigen::VectorXd derivative = program.G * x - program.g;
          Flags active(x.size());
          for (Eigen::Index s = 0; s < x.size(); ++s)
            active[s] = program.nonnegative[s] && x[s] < derivative[s];
          if (active == is_zero)
            {
              for (Eigen::Index s = 0; s < x.size(); ++s)
                if (program.nonnegative[s])
                  x[s] = std::max(x[s], 0.); // rounding errors
              return x;
            }
          is_zero = active;
          x       = solve_equations(program, is_zero);
        }
      return {};
    }

    template <typename Matrix>
    Eigen::VectorXd
    minimise(const UnitProgram<Matrix> &program)
    {
      const Eigen::VectorXd free =
        solve_equations(program, Flags(program.g.size(), false));
      if (const auto x = settle_bounds(program, free))
        return *x;
      const Eigen::VectorXd near = minimise_by_ipopt(to_sparse(program.G),
                                                     program.g,
                                                     program.nonnegative,
                                                     free);
      return settle_bounds(program, near).value_or(near);
    }

    template <typename Matrix>
    Eigen::VectorXd
    minimise_scaled(Matrix G,
                    const Eigen::VectorXd &g,
                    const Flags &nonnegative)
    {
      const Eigen::VectorXd diagonal = diagonal_of(G);
      if (!(diagonal.array() > 0.).all() || !diagonal.allFinite() ||
          !g.allFinite())
        throw not_positive();
      const Eigen::VectorXd unit   = diagonal.cwiseSqrt().cwiseInverse();
      const Eigen::VectorXd g_unit = unit.cwiseProduct(g);
      const double size            = g_unit.cwiseAbs().maxCoeff();
      if (size == 0.)
        return Eigen::VectorXd::Zero(g.size());

      G = unit.asDiagonal() * G * unit.asDiagonal();
      const UnitProgram<Matrix> program{std::move(G),
                                        g_unit / size,
                                        nonnegative};
      const Eigen::VectorXd x = minimise(program);
      const double gap        = optimality_gap(program, x);
      if (!(gap <= largest_gap(x)))
        {
          std::ostringstream text;
          text << "The fit misses its conditions of optimality by " << gap
               << " (relative).";
          throw RunError(text.str(),
                         "Improve the mesh, or choose another fit in 'Methods' "
                         "of section Fit.");
        }
      return size * unit.cwiseProduct(x);
    }
  } // namespace

  Eigen::VectorXd
  minimise_quadratic(const SparseMatrix &G,
                     const Eigen::VectorXd &g,
                     const Flags &nonnegative)
  {
    return minimise_scaled(G, g, nonnegative);
  }

  Eigen::VectorXd
  minimise_quadratic(Eigen::MatrixXd G,
                     const Eigen::VectorXd &g,
                     const Flags &nonnegative)
  {
    return minimise_scaled(std::move(G), g, nonnegative);
  }
} // namespace springfit
