#include <springfit/fit/cell/barrier_engine.h>
#include <springfit/fit/cell/certificate.h>
#include <springfit/fit/cell/ipopt_engine.h>
#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/rigid_modes.h>

#include <gtest/gtest.h>

#include <tuple>

#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  // The spectral program.

  TEST(Spectral, ProjectedProblemHasTheSameNorms)
  {
    Random random(7);
    for (const CellKind kind : all_kinds)
      {
        const auto problem      = oracle::random_problem(kind, random);
        const auto scaled       = spectral_problem(problem, 0);
        const Eigen::VectorXd k = random.matrix(problem.springs.size(), 1);
        EXPECT_NEAR(spectral_norm(scaled.R), 1., 1e-13);
        EXPECT_NEAR(scaled.scale * spectral_norm(residual(scaled, k)),
                    spectral_norm(residual(problem, scaled.scale * k)),
                    1e-12);
      }
  }

  TEST(Spectral, PivotsArePositiveExactlyInsideTheCone)
  {
    Random random(8);
    for (const CellKind kind : all_kinds)
      {
        const auto problem =
          spectral_problem(oracle::random_problem(kind, random), 0);
        Eigen::VectorXd x = random.matrix(problem.B.cols() + 1, 1);
        const double norm =
          spectral_norm(residual(problem, x.head(problem.B.cols())));
        x[problem.B.cols()] = 1.001 * norm;
        ASSERT_TRUE(pivots(problem, x));
        EXPECT_GT(pivots(problem, x)->minCoeff(), 0.);
        x[problem.B.cols()] = 0.999 * norm;
        EXPECT_FALSE(pivots(problem, x));
        EXPECT_FALSE(pivot_jacobian(problem, x));
      }
  }

  TEST(Spectral, PivotsAreThoseOfTheFactorisation)
  {
    Random random(9);
    const auto problem =
      spectral_problem(oracle::random_problem(CellKind::hexahedron, random), 0);
    const Eigen::VectorXd x = interior_point(problem);
    const Eigen::MatrixXd E = residual(problem, x.head(28));
    const Eigen::VectorXd d = *pivots(problem, x);
    // Pivots are ratios of leading principal minors.
    for (const double sign : {1., -1.})
      {
        const Eigen::MatrixXd A =
          x[28] * Eigen::MatrixXd::Identity(18, 18) - sign * E;
        double product = 1.;
        for (int i = 0; i < 18; ++i)
          {
            product *= d[(sign > 0. ? 0 : 18) + i];
            const double minor = A.topLeftCorner(i + 1, i + 1).determinant();
            EXPECT_NEAR(product / minor, 1., 1e-10);
          }
      }
  }

  TEST(Spectral, PivotDerivativesAgreeWithDifferences)
  {
    Random random(10);
    constexpr double h = 1e-5;
    for (const CellKind kind : all_kinds)
      {
        const auto problem =
          spectral_problem(oracle::random_problem(kind, random), 0);
        const Eigen::VectorXd x        = interior_point(problem);
        const Eigen::VectorXd weights  = random.matrix(2 * problem.R.rows(), 1);
        const Eigen::MatrixXd jacobian = *pivot_jacobian(problem, x);
        const Eigen::MatrixXd hessian  = *pivot_hessian(problem, x, weights);
        for (int a = 0; a < x.size(); ++a)
          {
            const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(x.size(), a);
            const Eigen::VectorXd first =
              (*pivots(problem, x + step) - *pivots(problem, x - step)) /
              (2. * h);
            EXPECT_LT((first - jacobian.col(a)).norm(),
                      1e-6 * (1. + jacobian.norm()));
            const Eigen::VectorXd second = (*pivot_jacobian(problem, x + step) -
                                            *pivot_jacobian(problem, x - step))
                                             .transpose() *
                                           weights / (2. * h);
            EXPECT_LT((second - hessian.col(a)).norm(),
                      1e-6 * (1. + hessian.norm()));
          }
      }
  }

  TEST(Spectral, PivotsAreConcave)
  {
    Random random(11);
    for (const CellKind kind : all_kinds)
      {
        const auto problem =
          spectral_problem(oracle::random_problem(kind, random), 0);
        const Eigen::VectorXd weights =
          random.matrix(2 * problem.R.rows(), 1).cwiseAbs();
        const Eigen::MatrixXd hessian =
          *pivot_hessian(problem, interior_point(problem), weights);
        const Eigen::VectorXd eigenvalues =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues();
        EXPECT_LE(eigenvalues.maxCoeff(), 1e-10 * hessian.norm());
        EXPECT_LT(eigenvalues.minCoeff(), -1e-3);
      }
  }

  TEST(Spectral, IpoptFindsNoErrorInTheDerivatives)
  {
    Random random(12);
    for (const CellKind kind : all_kinds)
      for (const bool nonnegative : {false, true})
        {
          const auto report = derivative_report(
            spectral_problem(oracle::random_problem(kind, random),
                             nonnegative ? node_pairs(kind).size() : 0));
          EXPECT_NE(report.find("No errors detected by derivative checker"),
                    std::string::npos)
            << report;
          // ... having looked at the second derivatives of every pivot.
          EXPECT_NE(report.find("second derivatives"), std::string::npos)
            << report;
        }
  }


  // The certificate.

  class Certificate
    : public ::testing::TestWithParam<std::tuple<CellKind, Engine, bool>>
  {};

  TEST_P(Certificate, IsSmallOnRandomCells)
  {
    const auto [kind, engine, nonnegative] = GetParam();
    Random random(13);
    for (unsigned int cell = 0; cell < 50; ++cell)
      {
        const auto result = fit(oracle::random_problem(kind, random),
                                method_named("spectral"),
                                options_of(engine, nonnegative));
        ASSERT_TRUE(result.duality_gap);
        EXPECT_LE(*result.duality_gap, 1e-6);
        EXPECT_GT(*result.duality_gap, -1e-12);
        EXPECT_LE(*result.duality_gap,
                  1e-6 * std::max(1e-3, result.spectral_residual));
      }
  }

  TEST_P(Certificate, BoundsEveryOtherFitFromBelow)
  {
    const auto [kind, engine, nonnegative] = GetParam();
    Random random(14);
    for (unsigned int cell = 0; cell < 5; ++cell)
      {
        const auto problem =
          spectral_problem(slender_problem(kind, random),
                           nonnegative ? node_pairs(kind).size() : 0);
        const auto solution = engine == Engine::ipopt
                                ? solve_by_ipopt(problem, 1e-10)
                                : solve_by_barrier(problem, 1e-10);
        const double bound =
          dual_bound(problem,
                     solution,
                     spectral_norm(residual(problem, solution.k)));
        EXPECT_GT(bound, 1e-3);
        for (const double size : {1e-8, 1e-4, 1e-2, 1.})
          for (unsigned int trial = 0; trial < 20; ++trial)
            {
              Eigen::VectorXd k =
                solution.k + size * random.matrix(solution.k.size(), 1);
              if (nonnegative)
                k = k.cwiseMax(0.);
              EXPECT_GE(spectral_norm(residual(problem, k)), bound - 1e-14);
            }
      }
  }

  TEST_P(Certificate, OfAWrongMultiplierIsStillValid)
  {
    const auto [kind, engine, nonnegative] = GetParam();
    Random random(15);
    const auto problem =
      spectral_problem(slender_problem(kind, random),
                       nonnegative ? node_pairs(kind).size() : 0);
    const auto solution  = solve_by_barrier(problem, 1e-10);
    const double optimum = spectral_norm(residual(problem, solution.k));
    const int n          = problem.R.rows();
    const auto bound_by  = [&](const Eigen::MatrixXd &multiplier) {
      return dual_bound(problem, {{}, multiplier, {}}, optimum);
    };
    double best = 0.;
    for (unsigned int trial = 0; trial < 100; ++trial)
      {
        const Eigen::MatrixXd noise = random.matrix(n, n);
        const Eigen::MatrixXd wrong =
          random(0., 1.) * solution.multiplier +
          random(0., 1.) * (noise + noise.transpose());
        best = std::max(best, bound_by(wrong));
        EXPECT_LE(bound_by(wrong), optimum + 1e-14);
      }
    EXPECT_GT(best, 0.); // so the bounds above were not all trivial

    // The limits: nothing, no number, the springs themselves (which no
    // multiplier may contain), a multiple.
    EXPECT_EQ(bound_by(Eigen::MatrixXd::Zero(n, n)), 0.);
    EXPECT_EQ(bound_by(Eigen::MatrixXd::Constant(
                n, n, std::numeric_limits<double>::quiet_NaN())),
              0.);
    EXPECT_LE(bound_by(problem.B * problem.B.transpose()), 1e-12);
    EXPECT_NEAR(bound_by(100. * solution.multiplier),
                bound_by(solution.multiplier),
                1e-12);
  }

  INSTANTIATE_TEST_SUITE_P(All,
                           Certificate,
                           ::testing::Combine(::testing::ValuesIn(all_kinds),
                                              ::testing::ValuesIn(all_engines),
                                              ::testing::Bool()));

  TEST(CertificateOfSlivers, OfAnObtuseTriangleIsNoMoreThanItsValue)
  {
    // Rounding of the projection passed for a bound here.
    const double slope      = std::tan(10. * M_PI / 180.);
    const Eigen::MatrixXd D = plane_strain(0.3);
    Eigen::MatrixXd points(2, 3);
    points << 0., 1., 0.5, 0., 0., 0.5 * slope;
    for (const Engine engine : all_engines)
      for (const bool nonnegative : {false, true})
        {
          FitOptions options = options_of(engine, nonnegative);
          options.enrichment = Enrichment::angles;
          const auto result =
            fit(make_fit_problem(points,
                                 CellKind::triangle,
                                 stiffness(points, CellKind::triangle, D),
                                 {1., 0.3, 1.}),
                method_named("spectral"),
                options);
          EXPECT_LE(*result.duality_gap, 1e-6);
          EXPECT_GT(*result.duality_gap, -1e-12);
        }
  }


  // Springs >= 0 and a cell that is no softer than a floor.

  TEST(SpectralFloor, IsMetAndCertified)
  {
    // Angles of a regular tetrahedron must be negative to give it its bulk
    // modulus; asked to be >= 0 they left 28.7 %.
    const auto problem = regular_problem(CellKind::tetrahedron, 0.45);
    for (const Engine engine : all_engines)
      {
        FitOptions options = options_of(engine, true);
        options.enrichment = Enrichment::angles;
        const auto result  = fit(problem, method_named("spectral"), options);
        EXPECT_LE(*result.duality_gap, 1e-6);
        EXPECT_GT(*result.duality_gap, -1e-12);
        EXPECT_EQ(result.n_negative, 0u);
        EXPECT_GE(*result.smallest_eigenvalue, 0.);
        const auto block = fit(problem, method_named("block"), options);
        if (*block.smallest_eigenvalue >= *result.smallest_eigenvalue)
          EXPECT_LE(result.spectral_residual, block.spectral_residual + 1e-9);
      }
  }

  TEST(SpectralFloor, IsAConstraintWithACertificateOfItsOwn)
  {
    Random random(17);
    unsigned int n_active = 0;
    for (const CellKind kind : all_kinds)
      for (unsigned int cell = 0; cell < 10; ++cell)
        {
          const auto problem      = slender_problem(kind, random);
          const Eigen::MatrixXd Q = deformation_basis(problem.points);
          // Softer deformations than this share of R are not allowed.
          const auto program = make_spectral_problem(
            problem.points,
            problem.gradients,
            problem.stiffness,
            problem.springs.size(),
            0.2 * Q * (Q.transpose() * problem.stiffness * Q) * Q.transpose());
          const auto without =
            spectral_problem(problem, problem.springs.size());
          double first = -1.;
          for (const Engine engine : all_engines)
            {
              const auto solution = engine == Engine::ipopt
                                      ? solve_by_ipopt(program, 1e-10)
                                      : solve_by_barrier(program, 1e-10);
              const double value = spectral_norm(residual(program, solution.k));
              const double bound = dual_bound(program, solution, value);
              EXPECT_LE(bound, value + 1e-14);
              EXPECT_LE(value - bound, 1e-6);
              if (first >= 0.)
                EXPECT_NEAR(value, first, 1e-7);
              first = value;
              const Eigen::MatrixXd K =
                program.R - residual(program, solution.k);
              EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                          K - program.least)
                          .eigenvalues()[0],
                        -1e-12);
              const auto free_solution = solve_by_barrier(without, 1e-10);
              const double of_free =
                spectral_norm(residual(without, free_solution.k));
              EXPECT_GE(value, of_free - 1e-8);
              n_active += value > of_free + 1e-6;
            }
        }
    EXPECT_GT(n_active, 10u); // so the constraint was one
  }

  TEST(Engines, Agree)
  {
    Random random(16);
    for (const CellKind kind : all_kinds)
      for (const bool nonnegative : {false, true})
        for (unsigned int cell = 0; cell < 10; ++cell)
          {
            const auto problem = slender_problem(kind, random);
            const auto ipopt   = fit(problem,
                                   method_named("spectral"),
                                   options_of(Engine::ipopt, nonnegative));
            const auto barrier = fit(problem,
                                     method_named("spectral"),
                                     options_of(Engine::barrier, nonnegative));
            EXPECT_NEAR(ipopt.spectral_residual,
                        barrier.spectral_residual,
                        1e-8);
            EXPECT_LT((ipopt.k() - barrier.k()).norm(),
                      1e-5 * barrier.k().norm());
          }
  }

  TEST(Engines, AgreeWhereTheMinimiserIsNotUnique)
  {
    const auto problem = regular_problem(CellKind::quadrilateral, 0.3);
    for (const bool nonnegative : {false, true})
      {
        const auto ipopt   = fit(problem,
                               method_named("spectral"),
                               options_of(Engine::ipopt, nonnegative));
        const auto barrier = fit(problem,
                                 method_named("spectral"),
                                 options_of(Engine::barrier, nonnegative));
        EXPECT_LT((ipopt.k() - barrier.k()).cwiseAbs().maxCoeff(), 1e-6);
      }
  }
} // namespace
