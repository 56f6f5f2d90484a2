#include <springfit/core/error.h>
#include <springfit/fit/cell/barrier_engine.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>
#include <vector>

namespace springfit
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /** One of the A, factorised. */
    struct Cone
    {
      double sign;  // dA/dk_s = sign b_s b_s^T
      double depth; // dA/dt = depth I
      Eigen::LLT<Eigen::MatrixXd> A;
    };

    /** All of them at x = (k, t). */
    struct Cones
    {
      Cones(const SpectralProblem &problem, const Eigen::VectorXd &x)
        : k(x.head(problem.B.cols())), t(x[problem.B.cols()])
      {
        const Eigen::MatrixXd E = residual(problem, k);
        const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(E.rows(), E.cols());
        all.push_back({1., 1., (t * I - E).llt()});
        all.push_back({-1., 1., (t * I + E).llt()});
        if (problem.least.size() > 0)
          all.push_back({1., 0., (problem.R - E - problem.least).llt()});
        inside = (k.head(problem.n_nonnegative).array() > 0.).all();
        for (const Cone &cone : all)
          inside = inside && cone.A.info() == Eigen::Success;
      }

      Eigen::VectorXd k;
      double t;
      std::vector<Cone> all;
      bool inside;
    };

    double
    log_det(const Eigen::LLT<Eigen::MatrixXd> &llt)
    {
      return 2. * llt.matrixLLT().diagonal().array().log().sum();
    }

    /** Infinite outside. */
    double
    barrier(const SpectralProblem &problem, const Cones &cones, const double mu)
    {
      if (!cones.inside)
        return infinity;
      double sum =
        cones.t / mu - cones.k.head(problem.n_nonnegative).array().log().sum();
      for (const Cone &cone : cones.all)
        sum -= log_det(cone.A);
      return sum;
    }

    struct Derivatives
    {
      Eigen::VectorXd gradient;
      Eigen::MatrixXd hessian; // lower triangle
    };

    /** Those of -log det A. */
    void
    add_cone(const Cone &cone,
             const Eigen::MatrixXd &B,
             Derivatives &derivatives)
    {
      const Eigen::Index n_springs = B.cols();
      const Eigen::MatrixXd X =
        cone.A.solve(Eigen::MatrixXd::Identity(B.rows(), B.rows()));
      const Eigen::MatrixXd X_B   = X * B;
      const Eigen::MatrixXd B_X_B = B.transpose() * X_B;

      derivatives.gradient.head(n_springs) -= cone.sign * B_X_B.diagonal();
      derivatives.gradient[n_springs] -= cone.depth * X.trace();
      derivatives.hessian.topLeftCorner(n_springs, n_springs) +=
        B_X_B.cwiseAbs2();
      derivatives.hessian.row(n_springs).head(n_springs) +=
        cone.depth * cone.sign * X_B.colwise().squaredNorm();
      derivatives.hessian(n_springs, n_springs) += cone.depth * X.squaredNorm();
    }

    Derivatives
    differentiate(const SpectralProblem &problem,
                  const Cones &cones,
                  const double mu)
    {
      const Eigen::Index n = problem.B.cols() + 1;
      Derivatives derivatives{Eigen::VectorXd::Unit(n, n - 1) / mu,
                              Eigen::MatrixXd::Zero(n, n)};
      for (const Cone &cone : cones.all)
        add_cone(cone, problem.B, derivatives);
      const Eigen::Index n_bounded  = problem.n_nonnegative;
      const Eigen::VectorXd inverse = cones.k.head(n_bounded).cwiseInverse();
      derivatives.gradient.head(n_bounded) -= inverse;
      derivatives.hessian.diagonal().head(n_bounded) += inverse.cwiseAbs2();
      return derivatives;
    }

    /** After scaling H to a unit diagonal: its entries range widely. */
    Eigen::VectorXd
    newton_step(const Derivatives &derivatives)
    {
      const Eigen::VectorXd scale =
        derivatives.hessian.diagonal().cwiseSqrt().cwiseInverse();
      const Eigen::MatrixXd scaled =
        scale.asDiagonal() * derivatives.hessian * scale.asDiagonal();
      return -scale.cwiseProduct(
        scaled.selfadjointView<Eigen::Lower>().ldlt().solve(
          scale.cwiseProduct(derivatives.gradient)));
    }

    /**
     * Newton's method to the minimiser for one mu. Ends when Newton's
     * decrement is below @p decrement_end, or when rounding lets it fall no
     * further.
     */
    Eigen::VectorXd
    centre(const SpectralProblem &problem,
           Eigen::VectorXd x,
           const double mu,
           const double decrement_end)
    {
      constexpr unsigned int n_steps_max = 60;

      double previous = infinity;
      for (unsigned int n_steps = 0; n_steps < n_steps_max; ++n_steps)
        {
          const Cones cones(problem, x);
          const Derivatives derivatives  = differentiate(problem, cones, mu);
          const Eigen::VectorXd step     = newton_step(derivatives);
          const double decrement_squared = -derivatives.gradient.dot(step);
          // Where the quadratic convergence of the last steps stalls, rounding
          // has the say.
          const bool stalls = previous < 1e-4 && decrement_squared > previous;
          if (!(decrement_squared > decrement_end * decrement_end) || stalls)
            return x;
          previous = decrement_squared;

          double length = 1.;
          // Near the centre full steps converge, and differences of the
          // barrier are too small to be computed.
          if (decrement_squared < 0.01)
            while (!Cones(problem, x + length * step).inside && length > 1e-8)
              length *= 0.5;
          else
            {
              const double start = barrier(problem, cones, mu);
              while (barrier(problem, Cones(problem, x + length * step), mu) >
                       start - 0.1 * length * decrement_squared &&
                     length > 1e-8)
                length *= 0.5;
            }
          if (length <= 1e-8)
            return x;
          x += length * step;
        }
      return x;
    }

    /**
     * The solution at the centre for mu, with its multipliers. There Y = mu
     * A^-1, but rounding in A^-1 spoils the constraints b_s^T (Y1 - Y2 + Y3)
     * b_s = 0. To first order in Newton's step, Y = mu (A^-1 - A^-1 dA A^-1),
     * they are Newton's equations, which hold to the accuracy of their
     * solution.
     */
    SpectralSolution
    solution_at(const SpectralProblem &problem,
                const Eigen::VectorXd &x,
                const double mu)
    {
      const Eigen::Index n_springs = problem.B.cols();
      const Cones cones(problem, x);
      const Eigen::VectorXd step =
        newton_step(differentiate(problem, cones, mu));

      const Eigen::MatrixXd dK =
        problem.B * step.head(n_springs).asDiagonal() * problem.B.transpose();
      const Eigen::Index n    = problem.B.rows();
      const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(n, n);
      SpectralSolution solution{cones.k, Eigen::MatrixXd::Zero(n, n), {}};
      for (const Cone &cone : cones.all)
        {
          const Eigen::MatrixXd dA =
            cone.sign * dK + cone.depth * step[n_springs] * I;
          const Eigen::MatrixXd X = cone.A.solve(I);
          const Eigen::MatrixXd Y = mu * (X - X * dA * X);
          if (cone.depth == 0.)
            solution.multiplier_of_least = Y;
          else
            solution.multiplier += cone.sign * Y;
        }
      return solution;
    }
  } // namespace


  SpectralSolution
  solve_by_barrier(const SpectralProblem &problem, const double mu)
  {
    constexpr double mu_start    = 1e-2;
    constexpr double mu_factor   = 0.05;
    constexpr double roughly     = 0.3;
    constexpr double to_rounding = 1e-9;

    Eigen::VectorXd x = interior_point(problem);
    if (!Cones(problem, x).inside)
      throw RunError("A spectral fit has no interior point to start from.",
                     "Check the cell's shape and material.");
    for (double now = mu_start; now > mu; now *= mu_factor)
      x = centre(problem, x, now, roughly);
    x = centre(problem, x, mu, to_rounding);

    return solution_at(problem, x, mu);
  }
} // namespace springfit
