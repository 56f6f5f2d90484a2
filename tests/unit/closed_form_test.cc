#include <springfit/fit/cell/block.h>
#include <springfit/fit/cell/frobenius.h>
#include <springfit/fit/cell/spectral.h>
#include <springfit/fit/fit.h>
#include <springfit/fit/programs/nonnegative_least_squares.h>

#include <gtest/gtest.h>

#include <cmath>

#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
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
     method_named("block"),
     {{1., 0.302198}, {root_2, 0.425824}},
     {}},
    {CellKind::quadrilateral,
     0.3,
     method_named("frobenius"),
     {{1., 0.298273}, {root_2, 0.400314}},
     {}},
    {CellKind::quadrilateral,
     1. / 3.,
     method_named("block"),
     {{1., 5. / 16.}, {root_2, 7. / 16.}},
     {}},
    {CellKind::quadrilateral,
     1. / 3.,
     method_named("frobenius"),
     {{1., 17. / 56.}, {root_2, 23. / 56.}},
     {}},
    {CellKind::hexahedron,
     0.3,
     method_named("block"),
     {{1., 0.106838}, {root_2, 0.165598}, {root_3, 0.138889}},
     {}},
    {CellKind::hexahedron,
     0.3,
     method_named("frobenius"),
     {{1., 0.0897436}, {root_2, 0.1324786}, {root_3, 0.0897436}},
     {}},
    {CellKind::hexahedron,
     0.3,
     method_named("spectral"),
     {{1., 0.1170690}, {root_2, 0.1285067}, {root_3, 0.1221094}},
     0.2576165},
    {CellKind::triangle, 1. / 3., method_named("block"), {{1., 0.4330127}}, 0.},
    {CellKind::triangle,
     1. / 3.,
     method_named("frobenius"),
     {{1., 0.4330127}},
     0.},
    {CellKind::triangle,
     1. / 3.,
     method_named("spectral"),
     {{1., 0.4330127}},
     0.},
    {CellKind::tetrahedron,
     0.25,
     method_named("frobenius"),
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
            expect_by_length(problem, result.k(), row.k_by_length, 1e-6);
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
          const auto result = fit(problem,
                                  method_named("spectral"),
                                  options_of(engine, nonnegative));
          const double t =
            result.spectral_residual * spectral_norm(problem.stiffness);
          // t* = 25/182, of which the table has six digits.
          EXPECT_NEAR(t, 25. / 182., 1e-6 * 25. / 182.);
          EXPECT_NEAR(25. / 182., 0.137363, 1e-6);
          for (const int edge : {0, 1, 4, 5})
            EXPECT_NEAR(result.k()[edge], 0.315934, 1e-6);
          for (const int diagonal : {2, 3})
            {
              EXPECT_GT(result.k()[diagonal], 0.323);
              EXPECT_LT(result.k()[diagonal], 0.460);
            }
          EXPECT_NEAR(result.k()[2], result.k()[3], 1e-6);
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
          fit(problem, method_named("spectral"), options_of(engine, false));
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
        const auto problem = oracle::random_problem(kind, random);
        const int dim      = dimension(kind);
        const Eigen::VectorXd k =
          fit_block(problem.gradients, problem.stiffness, dim, 0);
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
        // One quadratic per spring.
        EXPECT_LT((fit_block(problem.gradients,
                             problem.stiffness,
                             dim,
                             problem.springs.size()) -
                   k.cwiseMax(0.))
                    .norm(),
                  1e-13);
      }
  }

  TEST(Frobenius, NoNeighbourIsBetter)
  {
    Random random(3);
    for (const CellKind kind : all_kinds)
      {
        const auto problem = oracle::random_problem(kind, random);
        const Eigen::VectorXd k =
          fit_frobenius(problem.gradients, problem.stiffness, 0);
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
        const auto projected = spectral_problem(problem, 0);
        EXPECT_LT((fit_frobenius(problem.gradients, problem.stiffness, 0) -
                   projected.scale * fit_frobenius(projected.B, projected.R, 0))
                    .norm(),
                  1e-12);
      }
  }

  /**
   * Residuals of the optimality conditions of min x^T G x / 2 - g^T x with the
   * first @p n_bounded of x >= 0.
   */
  void
  expect_optimal(const Eigen::MatrixXd &G,
                 const Eigen::VectorXd &g,
                 const Eigen::VectorXd &x,
                 const int n_bounded)
  {
    const Eigen::VectorXd gradient = G * x - g;
    const double rounding          = 1e-12 * g.norm() * (1. + x.norm());
    for (int s = 0; s < n_bounded; ++s)
      {
        EXPECT_GE(x[s], 0.);
        EXPECT_GE(gradient[s], -rounding);
        EXPECT_NEAR(x[s] * gradient[s], 0., rounding);
      }
    for (int s = n_bounded; s < x.size(); ++s)
      EXPECT_NEAR(gradient[s], 0., rounding);
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
        for (const int n_bounded : {n, n / 2, 0})
          {
            const Eigen::VectorXd x =
              nonnegative_least_squares(G, g, n_bounded);
            expect_optimal(G, g, x, n_bounded);
            n_active += (x.array() == 0.).count();
            n_free += (x.tail(n - n_bounded).array() < 0.).count();
          }
      }
    EXPECT_GT(n_active, 500u);
    EXPECT_GT(n_free, 500u);
  }

  TEST(NonnegativeLeastSquares, Corners)
  {
    const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
    EXPECT_EQ(nonnegative_least_squares(I, Eigen::Vector2d(-1., -2.), 2),
              Eigen::VectorXd(Eigen::Vector2d(0., 0.)));
    EXPECT_EQ(nonnegative_least_squares(I, Eigen::Vector2d(0., 0.), 2),
              Eigen::VectorXd(Eigen::Vector2d(0., 0.)));
    EXPECT_EQ(nonnegative_least_squares(I, Eigen::Vector2d(3., -2.), 2),
              Eigen::VectorXd(Eigen::Vector2d(3., 0.)));
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
            fit_frobenius(problem.gradients, problem.stiffness, G.cols());
          expect_optimal(G, g, k, G.cols());
          n_active += (k.array() == 0.).count();
        }
    EXPECT_GT(n_active, 20u);
  }
} // namespace
