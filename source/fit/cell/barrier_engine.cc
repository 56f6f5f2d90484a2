#include <springfit/core/error.h>
#include <springfit/fit/cell/barrier_engine.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace springfit
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /** A1 and A2 at x = (k, t), factorised. */
    struct Cones
    {
      Cones(const SpectralProblem &problem, const Eigen::VectorXd &x)
        : k(x.head(problem.B.cols()))
        , t(x[problem.B.cols()])
        , E(residual(problem, k))
        , I(Eigen::MatrixXd::Identity(E.rows(), E.cols()))
        , lower(t * I - E)
        , upper(t * I + E)
        , inside(lower.info() == Eigen::Success &&
                 upper.info() == Eigen::Success &&
                 (k.head(problem.n_nonnegative).array() > 0.).all())
      {}

      Eigen::VectorXd k;
      double t;
      Eigen::MatrixXd E;
      Eigen::MatrixXd I;
      Eigen::LLT<Eigen::MatrixXd> lower;
      Eigen::LLT<Eigen::MatrixXd> upper;
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
      return cones.t / mu - log_det(cones.lower) - log_det(cones.upper) -
             cones.k.head(problem.n_nonnegative).array().log().sum();
    }

    struct Derivatives
    {
      Eigen::VectorXd gradient;
      Eigen::MatrixXd hessian; // lower triangle
    };

    /** Those of -log det A, dA/dk_s = sign b_s b_s^T, dA/dt = I. */
    void
    add_cone(const double sign,
             const Eigen::MatrixXd &B,
             const Eigen::LLT<Eigen::MatrixXd> &A,
             Derivatives &derivatives)
    {
      const Eigen::Index n_springs = B.cols();
      const Eigen::MatrixXd X =
        A.solve(Eigen::MatrixXd::Identity(B.rows(), B.rows()));
      const Eigen::MatrixXd X_B   = X * B;
      const Eigen::MatrixXd B_X_B = B.transpose() * X_B;

      derivatives.gradient.head(n_springs) -= sign * B_X_B.diagonal();
      derivatives.gradient[n_springs] -= X.trace();
      derivatives.hessian.topLeftCorner(n_springs, n_springs) +=
        B_X_B.cwiseAbs2();
      derivatives.hessian.row(n_springs).head(n_springs) +=
        sign * X_B.colwise().squaredNorm();
      derivatives.hessian(n_springs, n_springs) += X.squaredNorm();
    }

    Derivatives
    differentiate(const SpectralProblem &problem,
                  const Cones &cones,
                  const double mu)
    {
      const Eigen::Index n = problem.B.cols() + 1;
      Derivatives derivatives{Eigen::VectorXd::Unit(n, n - 1) / mu,
                              Eigen::MatrixXd::Zero(n, n)};
      add_cone(1., problem.B, cones.lower, derivatives);
      add_cone(-1., problem.B, cones.upper, derivatives);
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
     * Y1 - Y2 at the centre for mu. There Y = mu A^-1, but rounding in A^-1
     * spoils the constraints b_s^T (Y1 - Y2) b_s = 0. To first order in
     * Newton's step, Y = mu (A^-1 - A^-1 dA A^-1), they are Newton's
     * equations, which hold to the accuracy of their solution.
     */
    Eigen::MatrixXd
    multiplier(const SpectralProblem &problem,
               const Eigen::VectorXd &x,
               const double mu)
    {
      const Eigen::Index n_springs = problem.B.cols();
      const Cones cones(problem, x);
      const Eigen::VectorXd step =
        newton_step(differentiate(problem, cones, mu));

      const Eigen::MatrixXd dK =
        problem.B * step.head(n_springs).asDiagonal() * problem.B.transpose();
      const Eigen::MatrixXd dt = step[n_springs] * cones.I;
      const Eigen::MatrixXd X  = cones.lower.solve(cones.I);
      const Eigen::MatrixXd Z  = cones.upper.solve(cones.I);
      return mu * (X - X * (dt + dK) * X - Z + Z * (dt - dK) * Z);
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

    return {x.head(problem.B.cols()), multiplier(problem, x, mu)};
  }
} // namespace springfit
