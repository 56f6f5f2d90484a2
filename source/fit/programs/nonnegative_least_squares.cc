#include <springfit/core/error.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>
#include <vector>

namespace springfit
{
  namespace
  {
    using Indices = Eigen::VectorX<Eigen::Index>;

    Indices
    positions(const std::vector<bool> &is_free)
    {
      Indices free(std::count(is_free.begin(), is_free.end(), true));
      Eigen::Index n = 0;
      for (std::size_t s = 0; s < is_free.size(); ++s)
        if (is_free[s])
          free[n++] = s;
      return free;
    }

    /** The unconstrained minimiser with everything but @p free at zero. */
    Eigen::VectorXd
    minimise_over(const Eigen::MatrixXd &G,
                  const Eigen::VectorXd &g,
                  const Indices &free)
    {
      const Eigen::MatrixXd G_free = G(free, free);
      const Eigen::VectorXd g_free = g(free);
      const Eigen::LLT<Eigen::MatrixXd> cholesky(G_free);
      if (cholesky.info() != Eigen::Success)
        throw RunError("its springs cannot be told apart: the equations of the "
                       "fit are singular up to rounding.",
                       "Improve the mesh there: the cell is nearly flat.");
      const Eigen::VectorXd x_free = cholesky.solve(g_free);
      Eigen::VectorXd x            = Eigen::VectorXd::Zero(g.size());
      x(free)                      = x_free;
      return x;
    }

    /**
     * From a feasible @p x towards the minimiser over the free variables,
     * holding on the way those that would become negative.
     */
    Eigen::VectorXd
    descend(const Eigen::MatrixXd &G,
            const Eigen::VectorXd &g,
            const Eigen::Index n_nonnegative,
            Eigen::VectorXd x,
            std::vector<bool> &is_free)
    {
      while (true)
        {
          const Indices free           = positions(is_free);
          const Eigen::VectorXd target = minimise_over(G, g, free);

          double step          = 1.;
          Eigen::Index blocked = -1;
          for (const Eigen::Index s : free)
            if (s < n_nonnegative && target[s] <= 0. &&
                x[s] / (x[s] - target[s]) <= step)
              {
                step    = x[s] / (x[s] - target[s]);
                blocked = s;
              }
          if (blocked < 0)
            return target;

          x += step * (target - x);
          for (const Eigen::Index s : free)
            if (s < n_nonnegative && (s == blocked || x[s] <= 0.))
              {
                x[s]       = 0.;
                is_free[s] = false;
              }
        }
    }
  } // namespace

  Eigen::VectorXd
  nonnegative_least_squares(const Eigen::MatrixXd &G,
                            const Eigen::VectorXd &g,
                            const Eigen::Index n_nonnegative)
  {
    const Eigen::Index n  = g.size();
    const double rounding = 10. * n * std::numeric_limits<double>::epsilon() *
                            g.cwiseAbs().maxCoeff();

    std::vector<bool> is_free(n, true);
    std::fill_n(is_free.begin(), n_nonnegative, false);
    Eigen::VectorXd x = minimise_over(G, g, positions(is_free));
    // Each round lowers the objective, so no set of free variables returns;
    // in practice about n rounds suffice.
    for (Eigen::Index round = 0; round < 30 * n + 10; ++round)
      {
        Eigen::VectorXd descent = g - G * x;
        for (const Eigen::Index s : positions(is_free))
          descent[s] = 0.;

        Eigen::Index steepest;
        if (descent.maxCoeff(&steepest) <= rounding)
          return x;
        is_free[steepest] = true;
        x                 = descend(G, g, n_nonnegative, x, is_free);
      }
    throw RunError("its least squares fit with k >= 0 did not settle: its "
                   "equations are nearly singular.",
                   "Improve the mesh there: the cell may be nearly flat.");
  }
} // namespace springfit
