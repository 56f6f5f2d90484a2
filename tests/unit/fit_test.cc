#include <springfit/core/error.h>
#include <springfit/fit/barrier_engine.h>
#include <springfit/fit/block.h>
#include <springfit/fit/certificate.h>
#include <springfit/fit/fit.h>
#include <springfit/fit/frobenius.h>
#include <springfit/fit/ipopt_engine.h>
#include <springfit/fit/nonnegative_least_squares.h>
#include <springfit/fit/spectral.h>

#include <gtest/gtest.h>

#include <tuple>

#include "cells.h"

using namespace springfit;
using springfit::oracle::all_kinds;
using springfit::oracle::Random;

namespace
{
  const std::vector<Engine> all_engines = {Engine::ipopt, Engine::barrier};

  FitOptions
  options_of(const Engine engine, const bool nonnegative)
  {
    FitOptions options;
    options.engine      = engine;
    options.nonnegative = nonnegative;
    return options;
  }

  /** Every method, both engines, free and k >= 0. */
  std::vector<std::pair<Method, FitOptions>>
  all_fits()
  {
    std::vector<std::pair<Method, FitOptions>> fits;
    for (const bool nonnegative : {false, true})
      {
        for (const Method method : {Method::block, Method::frobenius})
          fits.emplace_back(method, options_of(Engine::ipopt, nonnegative));
        for (const Engine engine : all_engines)
          fits.emplace_back(Method::spectral, options_of(engine, nonnegative));
      }
    return fits;
  }

  FitProblem
  regular_problem(const CellKind kind, const double nu)
  {
    return oracle::fit_problem(oracle::regular_cell(kind), kind, nu);
  }

  /** Of the springs of regular cells with edges of length one. */
  void
  expect_by_length(const FitProblem &problem,
                   const Eigen::VectorXd &k,
                   const std::vector<std::pair<double, double>> &expected,
                   const double tolerance)
  {
    for (std::size_t s = 0; s < problem.springs.size(); ++s)
      {
        const auto [i, j] = problem.springs[s];
        const double length =
          (problem.points.col(j) - problem.points.col(i)).norm();
        bool found = false;
        for (const auto &[at_length, value] : expected)
          if (std::abs(length - at_length) < 1e-12)
            {
              EXPECT_NEAR(k[s], value, tolerance) << "length " << length;
              found = true;
            }
        EXPECT_TRUE(found) << "length " << length;
      }
  }

  const double root_2 = std::sqrt(2.), root_3 = std::sqrt(3.);


  // The element stiffness that everything is compared with.

  TEST(Oracle, StiffnessGivesTheEnergyOfUniformStrain)
  {
    Random random(1);
    for (const CellKind kind : all_kinds)
      {
        const int dim           = dimension(kind);
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const Eigen::MatrixXd D = oracle::usual_elasticity(kind, 0.3);
        const Eigen::MatrixXd R = oracle::stiffness(x, kind, D);
        // The measure, from a cube of unit stress: D = I, u = x.
        const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(D.rows(), D.cols());
        const Eigen::VectorXd u = x.reshaped();
        const double measure = u.dot(oracle::stiffness(x, kind, I) * u) / dim;

        const Eigen::MatrixXd H = random.matrix(dim, dim);
        const Eigen::VectorXd v = Eigen::MatrixXd(H * x).reshaped();
        Eigen::VectorXd strain(D.rows());
        strain.head(dim) = H.diagonal();
        int row          = dim;
        for (int a = 0; a < dim; ++a)
          for (int b = a + 1; b < dim; ++b)
            strain[row++] = H(a, b) + H(b, a);
        EXPECT_NEAR(v.dot(R * v), measure * strain.dot(D * strain), 1e-12);
      }
  }

  TEST(Oracle, PlaneStates)
  {
    // Uniaxial stress in plane stress: E = 1; in plane strain 1 / (1 - nu^2).
    const double nu = 0.3;
    EXPECT_NEAR(1. / oracle::plane_stress(nu).inverse()(0, 0), 1., 1e-14);
    EXPECT_NEAR(1. / oracle::plane_strain(nu).inverse()(0, 0),
                1. / (1. - nu * nu),
                1e-14);
    EXPECT_NEAR(1. / oracle::solid(nu).inverse()(0, 0), 1., 1e-14);
    EXPECT_NEAR(-oracle::solid(nu).inverse()(0, 1), nu, 1e-14);
  }


  // The table of checked values, E = 1, edges of length 1.

  struct Checked
  {
    CellKind kind;
    double nu;
    Method method;
    std::vector<std::pair<double, double>> k_by_length;
    std::optional<double> t;
  };

  const std::vector<Checked> checked_values = {
    {CellKind::quadrilateral,
     0.3,
     Method::block,
     {{1., 0.302198}, {root_2, 0.425824}},
     {}},
    {CellKind::quadrilateral,
     0.3,
     Method::frobenius,
     {{1., 0.298273}, {root_2, 0.400314}},
     {}},
    {CellKind::quadrilateral,
     1. / 3.,
     Method::block,
     {{1., 5. / 16.}, {root_2, 7. / 16.}},
     {}},
    {CellKind::quadrilateral,
     1. / 3.,
     Method::frobenius,
     {{1., 17. / 56.}, {root_2, 23. / 56.}},
     {}},
    {CellKind::hexahedron,
     0.3,
     Method::block,
     {{1., 0.106838}, {root_2, 0.165598}, {root_3, 0.138889}},
     {}},
    {CellKind::hexahedron,
     0.3,
     Method::frobenius,
     {{1., 0.0897436}, {root_2, 0.1324786}, {root_3, 0.0897436}},
     {}},
    {CellKind::hexahedron,
     0.3,
     Method::spectral,
     {{1., 0.1170690}, {root_2, 0.1285067}, {root_3, 0.1221094}},
     0.2576165},
    {CellKind::triangle, 1. / 3., Method::block, {{1., 0.4330127}}, 0.},
    {CellKind::triangle, 1. / 3., Method::frobenius, {{1., 0.4330127}}, 0.},
    {CellKind::triangle, 1. / 3., Method::spectral, {{1., 0.4330127}}, 0.},
    {CellKind::tetrahedron,
     0.25,
     Method::frobenius,
     {{1., 2. * root_2 / 25.}},
     {}}};

  TEST(CheckedValues, OfRegularCells)
  {
    for (const Checked &row : checked_values)
      for (const Engine engine : all_engines)
        for (const bool nonnegative : {false, true})
          {
            const auto problem = regular_problem(row.kind, row.nu);
            const auto result =
              fit(problem, row.method, options_of(engine, nonnegative));
            expect_by_length(problem, result.k, row.k_by_length, 1e-6);
            if (row.t)
              {
                const double t =
                  result.spectral_residual * spectral_norm(problem.stiffness);
                EXPECT_NEAR(t, *row.t, std::max(1e-6 * *row.t, 1e-8));
              }
          }
  }

  TEST(CheckedValues, SpectralFitOfTheSquare)
  {
    const auto problem = regular_problem(CellKind::quadrilateral, 0.3);
    for (const Engine engine : all_engines)
      for (const bool nonnegative : {false, true})
        {
          const auto result =
            fit(problem, Method::spectral, options_of(engine, nonnegative));
          const double t =
            result.spectral_residual * spectral_norm(problem.stiffness);
          // t* = 25/182, of which the table has six digits.
          EXPECT_NEAR(t, 25. / 182., 1e-6 * 25. / 182.);
          EXPECT_NEAR(25. / 182., 0.137363, 1e-6);
          for (const int edge : {0, 1, 4, 5})
            EXPECT_NEAR(result.k[edge], 0.315934, 1e-6);
          for (const int diagonal : {2, 3})
            {
              EXPECT_GT(result.k[diagonal], 0.323);
              EXPECT_LT(result.k[diagonal], 0.460);
            }
          EXPECT_NEAR(result.k[2], result.k[3], 1e-6);
        }
  }

  TEST(CheckedValues, SpectralFitOfTheCornerTetrahedron)
  {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(3, 4);
    x.rightCols(3).setIdentity();
    const auto problem = oracle::fit_problem(x, CellKind::tetrahedron, 0.3);
    for (const Engine engine : all_engines)
      {
        const auto result =
          fit(problem, Method::spectral, options_of(engine, false));
        const double t =
          result.spectral_residual * spectral_norm(problem.stiffness);
        EXPECT_NEAR(t, 0.4328168, 0.5e-6 * 0.4328168);
      }
  }


  // Each method against its definition.

  TEST(Block, MinimisesEachOffDiagonalBlock)
  {
    Random random(2);
    for (const CellKind kind : all_kinds)
      {
        const auto problem      = oracle::random_problem(kind, random);
        const Eigen::VectorXd k = fit_block(problem);
        const int dim           = dimension(kind);
        for (std::size_t s = 0; s < problem.springs.size(); ++s)
          {
            const auto [i, j] = problem.springs[s];
            const Eigen::VectorXd n =
              (problem.points.col(j) - problem.points.col(i)).normalized();
            const Eigen::MatrixXd block =
              problem.stiffness.block(dim * i, dim * j, dim, dim);
            const auto misfit = [&](const double value) {
              return (block + value * n * n.transpose()).squaredNorm();
            };
            // A parabola in k with curvature 2 and its vertex at k.
            EXPECT_NEAR(misfit(k[s] + 1.), misfit(k[s] - 1.), 1e-12);
            EXPECT_NEAR(misfit(k[s] + 1.) - misfit(k[s]), 1., 1e-12);
          }
        EXPECT_EQ(fit_block_nonnegative(problem), k.cwiseMax(0.));
      }
  }

  TEST(Frobenius, NoNeighbourIsBetter)
  {
    Random random(3);
    for (const CellKind kind : all_kinds)
      {
        const auto problem = oracle::random_problem(kind, random);
        const Eigen::VectorXd k =
          fit_frobenius(problem.gradients, problem.stiffness);
        const double best = residual(problem, k).squaredNorm();
        for (int s = 0; s < k.size(); ++s)
          {
            // Quadratic: the slope vanishes where both sides are alike.
            const Eigen::VectorXd step =
              0.1 * Eigen::VectorXd::Unit(k.size(), s);
            const double up   = residual(problem, k + step).squaredNorm();
            const double down = residual(problem, k - step).squaredNorm();
            EXPECT_NEAR(up, down, 1e-12);
            EXPECT_GT(up, best);
          }
      }
  }

  TEST(Frobenius, ProjectionOnTheDeformationsChangesNothing)
  {
    Random random(4);
    for (const CellKind kind : all_kinds)
      {
        const auto problem   = oracle::random_problem(kind, random);
        const auto projected = make_spectral_problem(problem, false);
        EXPECT_LT((fit_frobenius(problem.gradients, problem.stiffness) -
                   projected.scale * fit_frobenius(projected.B, projected.R))
                    .norm(),
                  1e-12);
      }
  }

  /** Residuals of the optimality conditions of min x^T G x / 2 - g^T x. */
  void
  expect_optimal(const Eigen::MatrixXd &G,
                 const Eigen::VectorXd &g,
                 const Eigen::VectorXd &x)
  {
    const Eigen::VectorXd gradient = G * x - g;
    EXPECT_GE(x.minCoeff(), 0.);
    EXPECT_GE(gradient.minCoeff(), -1e-12 * g.norm());
    EXPECT_LT(x.cwiseProduct(gradient).cwiseAbs().maxCoeff(),
              1e-12 * g.norm() * (1. + x.norm()));
  }

  TEST(NonnegativeLeastSquares, OptimalityConditionsHold)
  {
    Random random(5);
    unsigned int n_active = 0, n_free = 0;
    for (unsigned int trial = 0; trial < 200; ++trial)
      {
        const int n             = 1 + trial % 28;
        const Eigen::MatrixXd A = random.matrix(n + 5, n);
        const Eigen::MatrixXd G = A.transpose() * A;
        const Eigen::VectorXd g = A.transpose() * random.matrix(n + 5, 1);
        const Eigen::VectorXd x = nonnegative_least_squares(G, g);
        expect_optimal(G, g, x);
        n_active += (x.array() == 0.).count();
        n_free += (x.array() > 0.).count();
      }
    EXPECT_GT(n_active, 500u);
    EXPECT_GT(n_free, 500u);
  }

  TEST(NonnegativeLeastSquares, Corners)
  {
    const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
    EXPECT_EQ(nonnegative_least_squares(I, Eigen::Vector2d(-1., -2.)),
              Eigen::VectorXd(Eigen::Vector2d(0., 0.)));
    EXPECT_EQ(nonnegative_least_squares(I, Eigen::Vector2d(0., 0.)),
              Eigen::VectorXd(Eigen::Vector2d(0., 0.)));
    EXPECT_EQ(nonnegative_least_squares(I, Eigen::Vector2d(3., -2.)),
              Eigen::VectorXd(Eigen::Vector2d(3., 0.)));
  }

  /** Slender cells: many of their free fits have negative springs. */
  FitProblem
  slender_problem(const CellKind kind, Random &random)
  {
    Eigen::MatrixXd x = oracle::random_cell(kind, random);
    x.row(0) *= 3.;
    return oracle::fit_problem(x, kind, random(0., 0.45));
  }

  TEST(Frobenius, NonnegativeFitIsOptimal)
  {
    Random random(6);
    unsigned int n_active = 0;
    for (const CellKind kind : all_kinds)
      for (unsigned int cell = 0; cell < 25; ++cell)
        {
          const auto problem      = slender_problem(kind, random);
          const Eigen::MatrixXd G = tangent_gram(problem.gradients);
          const Eigen::VectorXd g =
            tangent_products(problem.gradients, problem.stiffness);
          const Eigen::VectorXd k =
            fit_frobenius_nonnegative(problem.gradients, problem.stiffness);
          expect_optimal(G, g, k);
          n_active += (k.array() == 0.).count();
        }
    EXPECT_GT(n_active, 20u);
  }


  // The spectral program.

  TEST(Spectral, ProjectedProblemHasTheSameNorms)
  {
    Random random(7);
    for (const CellKind kind : all_kinds)
      {
        const auto problem      = oracle::random_problem(kind, random);
        const auto scaled       = make_spectral_problem(problem, false);
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
          make_spectral_problem(oracle::random_problem(kind, random), false);
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
    const auto problem = make_spectral_problem(
      oracle::random_problem(CellKind::hexahedron, random), false);
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
          make_spectral_problem(oracle::random_problem(kind, random), false);
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
          make_spectral_problem(oracle::random_problem(kind, random), false);
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
            make_spectral_problem(oracle::random_problem(kind, random),
                                  nonnegative));
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
                                Method::spectral,
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
          make_spectral_problem(slender_problem(kind, random), nonnegative);
        const auto solution = engine == Engine::ipopt
                                ? solve_by_ipopt(problem, 1e-10)
                                : solve_by_barrier(problem, 1e-10);
        const double bound  = dual_bound(problem, solution.multiplier);
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
      make_spectral_problem(slender_problem(kind, random), nonnegative);
    const auto solution  = solve_by_barrier(problem, 1e-10);
    const double optimum = spectral_norm(residual(problem, solution.k));
    const int n          = problem.R.rows();
    double best          = 0.;
    for (unsigned int trial = 0; trial < 100; ++trial)
      {
        const Eigen::MatrixXd noise = random.matrix(n, n);
        const Eigen::MatrixXd wrong =
          random(0., 1.) * solution.multiplier +
          random(0., 1.) * (noise + noise.transpose());
        best = std::max(best, dual_bound(problem, wrong));
        EXPECT_LE(dual_bound(problem, wrong), optimum + 1e-14);
      }
    EXPECT_GT(best, 0.); // so the bounds above were not all trivial

    // The limits: nothing, no number, the springs themselves (which no
    // multiplier may contain), a multiple.
    EXPECT_EQ(dual_bound(problem, Eigen::MatrixXd::Zero(n, n)), 0.);
    EXPECT_EQ(dual_bound(problem,
                         Eigen::MatrixXd::Constant(
                           n, n, std::numeric_limits<double>::quiet_NaN())),
              0.);
    EXPECT_LE(dual_bound(problem, problem.B * problem.B.transpose()), 1e-12);
    EXPECT_NEAR(dual_bound(problem, 100. * solution.multiplier),
                dual_bound(problem, solution.multiplier),
                1e-12);
  }

  INSTANTIATE_TEST_SUITE_P(All,
                           Certificate,
                           ::testing::Combine(::testing::ValuesIn(all_kinds),
                                              ::testing::ValuesIn(all_engines),
                                              ::testing::Bool()));

  TEST(Engines, Agree)
  {
    Random random(16);
    for (const CellKind kind : all_kinds)
      for (const bool nonnegative : {false, true})
        for (unsigned int cell = 0; cell < 10; ++cell)
          {
            const auto problem = slender_problem(kind, random);
            const auto ipopt   = fit(problem,
                                   Method::spectral,
                                   options_of(Engine::ipopt, nonnegative));
            const auto barrier = fit(problem,
                                     Method::spectral,
                                     options_of(Engine::barrier, nonnegative));
            EXPECT_NEAR(ipopt.spectral_residual,
                        barrier.spectral_residual,
                        1e-8);
            EXPECT_LT((ipopt.k - barrier.k).norm(), 1e-5 * barrier.k.norm());
          }
  }

  TEST(Engines, AgreeWhereTheMinimiserIsNotUnique)
  {
    const auto problem = regular_problem(CellKind::quadrilateral, 0.3);
    for (const bool nonnegative : {false, true})
      {
        const auto ipopt   = fit(problem,
                               Method::spectral,
                               options_of(Engine::ipopt, nonnegative));
        const auto barrier = fit(problem,
                                 Method::spectral,
                                 options_of(Engine::barrier, nonnegative));
        EXPECT_LT((ipopt.k - barrier.k).cwiseAbs().maxCoeff(), 1e-6);
      }
  }


  // Invariance: k belongs to the spring, not to coordinates or numbers.

  double
  tolerance_of(const Method method)
  {
    return method == Method::spectral ? 1e-6 : 1e-12;
  }

  std::vector<FitProblem>
  cells_for_invariance(const CellKind kind, Random &random)
  {
    return {regular_problem(kind, 0.3), slender_problem(kind, random)};
  }

  /** k of the same springs when the cell is @p x with R from nu = 0.3. */
  Eigen::VectorXd
  k_of(const Eigen::MatrixXd &x,
       const CellKind kind,
       const Method method,
       const FitOptions &options)
  {
    return fit(oracle::fit_problem(x, kind, 0.3), method, options).k;
  }

  TEST(Invariance, UnderMotions)
  {
    Random random(17);
    for (const CellKind kind : all_kinds)
      for (const auto &problem : cells_for_invariance(kind, random))
        for (const auto &[method, options] : all_fits())
          {
            const Eigen::MatrixXd &x = problem.points;
            const Eigen::MatrixXd y =
              (random.rotation(x.rows()) * x).colwise() +
              Eigen::VectorXd(random.matrix(x.rows(), 1));
            EXPECT_LT((k_of(x, kind, method, options) -
                       k_of(y, kind, method, options))
                        .cwiseAbs()
                        .maxCoeff(),
                      tolerance_of(method));
          }
  }

  TEST(Invariance, UnderScaling)
  {
    Random random(18);
    for (const CellKind kind : all_kinds)
      for (const auto &problem : cells_for_invariance(kind, random))
        for (const auto &[method, options] : all_fits())
          {
            const Eigen::MatrixXd &x = problem.points;
            const double size        = 0.0025;
            // As E h in 2-d, as E L in 3-d.
            const double factor = dimension(kind) == 2 ? 1. : size;
            EXPECT_LT((factor * k_of(x, kind, method, options) -
                       k_of(size * x, kind, method, options))
                        .cwiseAbs()
                        .maxCoeff(),
                      factor * tolerance_of(method));
          }
  }

  TEST(Invariance, UnderRenumbering)
  {
    Random random(19);
    for (const CellKind kind : all_kinds)
      for (const auto &problem : cells_for_invariance(kind, random))
        for (const auto &[method, options] : all_fits())
          {
            const Eigen::MatrixXd &x = problem.points;
            const auto &p =
              symmetries(kind)[1 + random() * (symmetries(kind).size() - 1)];
            Eigen::MatrixXd y(x.rows(), x.cols());
            for (int v = 0; v < x.cols(); ++v)
              y.col(p[v]) = x.col(v);
            const auto &pairs = node_pairs(kind);
            const auto k_of_x = k_of(x, kind, method, options);
            const auto k_of_y = k_of(y, kind, method, options);
            for (std::size_t s = 0; s < pairs.size(); ++s)
              {
                const auto [i, j] = std::minmax(p[pairs[s][0]], p[pairs[s][1]]);
                const auto at =
                  std::find(pairs.begin(), pairs.end(), NodePair{{i, j}});
                EXPECT_NEAR(k_of_x[s],
                            k_of_y[at - pairs.begin()],
                            tolerance_of(method));
              }
          }
  }


  // The result.

  TEST(Fit, ResidualsAreRelativeToTheirNorms)
  {
    Random random(30);
    for (const CellKind kind : all_kinds)
      for (const auto &[method, options] : all_fits())
        {
          const auto problem       = oracle::random_problem(kind, random);
          const auto result        = fit(problem, method, options);
          const Eigen::MatrixXd &R = problem.stiffness;
          Eigen::MatrixXd E        = R;
          for (int s = 0; s < result.k.size(); ++s)
            E -= result.k[s] * problem.gradients.col(s) *
                 problem.gradients.col(s).transpose();
          EXPECT_NEAR(result.frobenius_residual, E.norm() / R.norm(), 1e-12);
          // The largest singular value, by another algorithm.
          EXPECT_NEAR(
            result.spectral_residual,
            Eigen::JacobiSVD<Eigen::MatrixXd>(E).singularValues()[0] /
              Eigen::JacobiSVD<Eigen::MatrixXd>(R).singularValues()[0],
            1e-10);
          EXPECT_EQ(result.duality_gap.has_value(), method == Method::spectral);
        }
  }

  TEST(Fit, EachMethodIsTheBestInItsNorm)
  {
    Random random(31);
    for (const CellKind kind : all_kinds)
      for (const bool nonnegative : {false, true})
        {
          const auto problem   = slender_problem(kind, random);
          const auto options   = options_of(Engine::ipopt, nonnegative);
          const auto block     = fit(problem, Method::block, options);
          const auto frobenius = fit(problem, Method::frobenius, options);
          const auto spectral  = fit(problem, Method::spectral, options);
          EXPECT_LT(frobenius.frobenius_residual, block.frobenius_residual);
          EXPECT_LT(frobenius.frobenius_residual, spectral.frobenius_residual);
          EXPECT_LT(spectral.spectral_residual, block.spectral_residual);
          EXPECT_LT(spectral.spectral_residual, frobenius.spectral_residual);
        }
  }

  TEST(Fit, NonnegativeKeepsItsWord)
  {
    Random random(32);
    unsigned int n_negative_when_free = 0;
    for (const CellKind kind : all_kinds)
      for (auto [method, options] : all_fits())
        if (options.nonnegative)
          for (unsigned int cell = 0; cell < 5; ++cell)
            {
              const auto problem = slender_problem(kind, random);
              const auto result  = fit(problem, method, options);
              EXPECT_GE(result.k.minCoeff(), 0.);
              EXPECT_EQ(result.n_negative, 0u);
              FitOptions free  = options;
              free.nonnegative = false;
              n_negative_when_free += fit(problem, method, free).n_negative;
            }
    EXPECT_GT(n_negative_when_free, 20u);
  }

  TEST(Fit, PlaneStrainIsFittedAsWell)
  {
    // The equilateral triangle is exact at nu = 1/4 (Cauchy's relation).
    const Eigen::MatrixXd x = oracle::regular_cell(CellKind::triangle);
    const auto problem =
      make_fit_problem(x,
                       CellKind::triangle,
                       oracle::simplex_stiffness(x,
                                                 oracle::plane_strain(0.25)));
    for (const auto &[method, options] : all_fits())
      EXPECT_LT(fit(problem, method, options).spectral_residual, 1e-8);
  }

  TEST(Fit, WhatIsNoStiffnessIsRefused)
  {
    auto problem = regular_problem(CellKind::triangle, 0.3);
    problem.stiffness.setZero();
    EXPECT_THROW(fit(problem, Method::frobenius, {}), RunError);
    problem.stiffness(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(fit(problem, Method::spectral, {}), RunError);
  }

  TEST(Fit, Words)
  {
    EXPECT_EQ(words_of(method_words()),
              (std::vector<std::string>{"block", "frobenius", "spectral"}));
    EXPECT_EQ(words_of(engine_words()),
              (std::vector<std::string>{"ipopt", "barrier"}));
  }
} // namespace
