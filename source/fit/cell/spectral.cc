#include <springfit/core/error.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/cell/spectral.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <vector>

namespace springfit
{
  namespace
  {
    /**
     * One of the cones at a point, A = C C^T = L D L^T, seen through C^-1: with
     * L = C D^(-1/2) the derivatives of the pivots need L^-1 b_s = D^(1/2) u_s
     * and L^-1 L^-T = D^(1/2) V D^(1/2).
     */
    struct Cone
    {
      /** dA/dk_s = sign b_s b_s^T */
      double sign;

      /** dA/dt = depth I: 1, or 0 of A3 */
      double depth;

      Eigen::MatrixXd inverse_factor; // C^-1
      Eigen::VectorXd d;              // the pivots, diag(C)^2
    };

    std::optional<Cone>
    make_cone(const double sign, const double depth, const Eigen::MatrixXd &A)
    {
      const Eigen::LLT<Eigen::MatrixXd> llt(A);
      if (!(llt.info() == Eigen::Success))
        return {};
      Cone cone{sign,
                depth,
                Eigen::MatrixXd::Identity(A.rows(), A.cols()),
                llt.matrixLLT().diagonal().cwiseAbs2()};
      llt.matrixL().solveInPlace(cone.inverse_factor);
      if (!(cone.d.minCoeff() > 0.) || !cone.inverse_factor.allFinite())
        return {};
      return cone;
    }

    bool
    has_least(const SpectralProblem &problem)
    {
      return problem.least.size() > 0;
    }

    /** All of them at x = (k, t), or none when one is not definite. */
    std::vector<Cone>
    make_cones(const SpectralProblem &problem, const Eigen::VectorXd &x)
    {
      const Eigen::Index n_springs = problem.B.cols();
      const Eigen::MatrixXd E      = residual(problem, x.head(n_springs));
      const Eigen::MatrixXd t =
        x[n_springs] * Eigen::MatrixXd::Identity(E.rows(), E.cols());
      std::vector<std::optional<Cone>> found = {make_cone(1., 1., t - E),
                                                make_cone(-1., 1., t + E)};
      if (has_least(problem))
        found.push_back(make_cone(1., 0., problem.R - E - problem.least));
      std::vector<Cone> cones;
      for (const auto &cone : found)
        if (cone)
          cones.push_back(*cone);
      return cones.size() == found.size() ? cones : std::vector<Cone>();
    }

    /**
     * The second derivatives of sum_i w_i d_i in one cone, lower triangle:
     * d2(d_i) / da db = -2 sum_{j<i} (W_a)_ij (W_b)_ij / d_j with
     * W_a = L^-1 (dA/da) L^-T.
     */
    Eigen::MatrixXd
    cone_hessian(const Cone &cone,
                 const Eigen::MatrixXd &B,
                 const Eigen::Ref<const Eigen::VectorXd> &weights)
    {
      const Eigen::Index n         = B.rows();
      const Eigen::Index n_springs = B.cols();
      const Eigen::MatrixXd U      = cone.inverse_factor * B;
      const Eigen::MatrixXd V =
        cone.inverse_factor * cone.inverse_factor.transpose();
      const Eigen::VectorXd w = -2. * weights.cwiseProduct(cone.d);

      Eigen::MatrixXd hessian =
        Eigen::MatrixXd::Zero(n_springs + 1, n_springs + 1);
      for (Eigen::Index t = 0; t < n_springs; ++t)
        for (Eigen::Index s = t; s < n_springs; ++s)
          {
            double before = 0.; // sum_{j<i} u_sj u_tj
            double sum    = 0.;
            for (Eigen::Index i = 0; i < n; ++i)
              {
                const double product = U(i, s) * U(i, t);
                sum += w[i] * product * before;
                before += product;
              }
            hessian(s, t) = sum;
          }

      if (cone.depth == 0.)
        return hessian;
      // The row of t, whose W is full.
      for (Eigen::Index i = 1; i < n; ++i)
        {
          const Eigen::RowVectorXd v = V.row(i).head(i);
          hessian.row(n_springs).head(n_springs) +=
            cone.sign * w[i] * (v * U.topRows(i)).cwiseProduct(U.row(i));
          hessian(n_springs, n_springs) += w[i] * v.squaredNorm();
        }
      return hessian;
    }
  } // namespace


  SpectralProblem
  make_spectral_problem(const Eigen::MatrixXd &points,
                        const Eigen::MatrixXd &B,
                        const Eigen::MatrixXd &R,
                        const Eigen::Index n_nonnegative,
                        const Eigen::MatrixXd &least)
  {
    const Eigen::MatrixXd Q         = deformation_basis(points);
    const Eigen::MatrixXd projected = Q.transpose() * R * Q;
    const double scale              = spectral_norm(projected);
    SpectralProblem problem{projected / scale,
                            Q.transpose() * B,
                            scale,
                            n_nonnegative};
    if (least.size() > 0)
      problem.least = Q.transpose() * least * Q / scale;
    return problem;
  }


  Eigen::VectorXd
  interior_point(const SpectralProblem &problem)
  {
    // Well above the bounds, also where the residual vanishes: a path that
    // starts near the boundary is slow to leave it.
    constexpr double k_floor = 0.01;
    constexpr double t_floor = 0.05;
    constexpr double above   = 1.5; // times the least stiffness

    Eigen::VectorXd k  = fit_frobenius(problem.B, problem.R, 0);
    const auto bounded = Eigen::seqN(0, problem.n_nonnegative);
    k(bounded)         = k(bounded).cwiseMax(k_floor).eval();
    if (has_least(problem))
      {
        const Eigen::MatrixXd wanted = above * problem.least;
        const auto inside            = [&](const Eigen::VectorXd &constants) {
          const Eigen::MatrixXd K = problem.R - residual(problem, constants);
          return Eigen::LLT<Eigen::MatrixXd>(K - wanted).info() ==
                 Eigen::Success;
        };
        Eigen::VectorXd equal = Eigen::VectorXd::Zero(k.size());
        equal(bounded).setConstant(k_floor);
        for (unsigned int doublings = 0; !inside(equal); ++doublings)
          {
            constexpr unsigned int most = 60;
            if (doublings == most)
              throw RunError("its springs cannot be as stiff as they should.",
                             "Improve the mesh there.");
            equal *= 2.;
          }
        double share = 0.;
        while (!inside((1. - share) * k + share * equal))
          share += 0.125;
        k = ((1. - share) * k + share * equal).eval();
      }
    Eigen::VectorXd x(k.size() + 1);
    x << k, 1.2 * spectral_norm(residual(problem, k)) + t_floor;
    return x;
  }


  Eigen::MatrixXd
  residual(const SpectralProblem &problem,
           const Eigen::Ref<const Eigen::VectorXd> &k)
  {
    const Eigen::MatrixXd weighted = problem.B * k.asDiagonal();
    return problem.R - weighted * problem.B.transpose();
  }


  double
  spectral_norm(const Eigen::MatrixXd &symmetric)
  {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
             symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
  }


  Eigen::Index
  n_pivots(const SpectralProblem &problem)
  {
    return (has_least(problem) ? 3 : 2) * problem.R.rows();
  }


  std::optional<Eigen::VectorXd>
  pivots(const SpectralProblem &problem, const Eigen::VectorXd &x)
  {
    const auto cones = make_cones(problem, x);
    if (cones.empty())
      return {};
    Eigen::VectorXd d(n_pivots(problem));
    for (std::size_t c = 0; c < cones.size(); ++c)
      d.segment(c * problem.R.rows(), problem.R.rows()) = cones[c].d;
    return d;
  }


  std::optional<Eigen::MatrixXd>
  pivot_jacobian(const SpectralProblem &problem, const Eigen::VectorXd &x)
  {
    const Eigen::Index n         = problem.B.rows();
    const Eigen::Index n_springs = problem.B.cols();
    const auto cones             = make_cones(problem, x);
    if (cones.empty())
      return {};
    Eigen::MatrixXd jacobian(n_pivots(problem), n_springs + 1);
    for (std::size_t c = 0; c < cones.size(); ++c)
      {
        const Cone &cone = cones[c];
        auto rows        = jacobian.middleRows(c * n, n);
        rows.leftCols(n_springs) =
          cone.sign * cone.d.asDiagonal() *
          (cone.inverse_factor * problem.B).cwiseAbs2();
        rows.col(n_springs) =
          cone.depth *
          cone.d.cwiseProduct(cone.inverse_factor.rowwise().squaredNorm());
      }
    return jacobian;
  }


  std::optional<Eigen::MatrixXd>
  pivot_hessian(const SpectralProblem &problem,
                const Eigen::VectorXd &x,
                const Eigen::VectorXd &weights)
  {
    const Eigen::Index n = problem.B.rows();
    const auto cones     = make_cones(problem, x);
    if (cones.empty())
      return {};
    Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(x.size(), x.size());
    for (std::size_t c = 0; c < cones.size(); ++c)
      lower += cone_hessian(cones[c], problem.B, weights.segment(c * n, n));
    return Eigen::MatrixXd(lower.selfadjointView<Eigen::Lower>());
  }


  std::optional<SpectralSolution>
  pivot_solution(const SpectralProblem &problem,
                 const Eigen::VectorXd &x,
                 const Eigen::VectorXd &y)
  {
    const Eigen::Index n = problem.B.rows();
    const auto cones     = make_cones(problem, x);
    if (cones.empty())
      return {};
    SpectralSolution solution{x.head(problem.B.cols()),
                              Eigen::MatrixXd::Zero(n, n),
                              {}};
    for (std::size_t c = 0; c < cones.size(); ++c)
      {
        // L^-1 = D^(1/2) C^-1
        const Cone &cone = cones[c];
        const Eigen::VectorXd weights =
          y.segment(c * n, n).cwiseProduct(cone.d);
        const Eigen::MatrixXd Y = cone.inverse_factor.transpose() *
                                  weights.asDiagonal() * cone.inverse_factor;
        if (cone.depth == 0.)
          solution.multiplier_of_least = Y;
        else
          solution.multiplier += cone.sign * Y;
      }
    return solution;
  }
} // namespace springfit
