// The patch test of a cell: what every fit with every enrichment does in a
// field of constant strain, against what theory predicts.

#include <springfit/fit/cell/consistent.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/rigid_modes.h>
#include <springfit/springs/volume.h>

#include <gtest/gtest.h>

#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  /** The nodal displacement of a constant gradient. */
  Eigen::VectorXd
  affine_field(const Eigen::MatrixXd &points, const Eigen::MatrixXd &gradient)
  {
    return (gradient * points).reshaped();
  }

  /** A symmetric gradient, whose field no rigid motion makes. */
  Eigen::VectorXd
  random_strain_field(const Eigen::MatrixXd &points, Random &random)
  {
    const Eigen::MatrixXd m = random.matrix(points.rows(), points.rows());
    return affine_field(points, m + m.transpose());
  }

  Eigen::MatrixXd
  stiffness_of(const FitProblem &problem, const CellModel &model)
  {
    return problem.stiffness - residual(problem, model);
  }

  FitOptions
  options_with(const Enrichment enrichment, const bool nonnegative)
  {
    FitOptions options;
    options.enrichment  = enrichment;
    options.nonnegative = nonnegative;
    options.engine      = Engine::barrier;
    return options;
  }

  const std::vector<Method> fits_of_a_matrix = {method_named("block"),
                                                method_named("frobenius"),
                                                method_named("spectral"),
                                                method_named("consistent"),
                                                method_named("compliance")};

  const std::vector<Enrichment> all_enrichments = {Enrichment::none,
                                                   Enrichment::volume,
                                                   Enrichment::angles,
                                                   Enrichment::coupling};

  /** ||(R - K) u|| / ||R u|| in a random field of constant strain. */
  double
  patch_residual(const FitProblem &problem,
                 const CellModel &model,
                 Random &random)
  {
    const Eigen::VectorXd u = random_strain_field(problem.points, random);
    return (residual(problem, model) * u).norm() /
           (problem.stiffness * u).norm();
  }

  TEST(PatchTest, CouplingsAreExactInEveryFit)
  {
    Random random(101);
    for (const CellKind kind : all_kinds)
      for (const Method &method : fits_of_a_matrix)
        for (const bool nonnegative : {false, true})
          for (unsigned int cell = 0; cell < 5; ++cell)
            {
              const auto problem = oracle::random_problem(kind, random);
              const auto result =
                fit(problem,
                    method,
                    options_with(Enrichment::coupling, nonnegative));
              EXPECT_LT(patch_residual(problem, result, random), 1e-12);
              // The whole matrix, not the affine modes alone.
              EXPECT_LT(result.spectral_residual, 1e-12);
              EXPECT_GE(result.k().minCoeff(), 0.);
            }
  }

  TEST(PatchTest, CoefficientsOfACoupledSimplex)
  {
    Random random(102);
    const auto options = options_with(Enrichment::coupling, true);
    for (const auto &[kind, n] : {std::pair{CellKind::triangle, 6},
                                  std::pair{CellKind::tetrahedron, 21}})
      {
        const auto result = fit(oracle::random_problem(kind, random),
                                method_named("frobenius"),
                                options);
        EXPECT_EQ(result.k().size() + constants_of(result, "couplings").size(),
                  n);
      }
  }

  /** The invariants C_iijj and C_ijij of a cell's affine energies. */
  std::pair<double, double>
  invariants(const Eigen::MatrixXd &points, const Eigen::MatrixXd &K)
  {
    const int dim = points.rows();
    // The strain that the component (a, b) of a tensor stands for.
    const auto field = [&](const int a, const int b) {
      Eigen::MatrixXd strain = Eigen::MatrixXd::Zero(dim, dim);
      strain(a, b) += 0.5;
      strain(b, a) += 0.5;
      return affine_field(points, strain);
    };
    double iijj = 0., ijij = 0.;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b)
        {
          iijj += field(a, a).dot(K * field(b, b));
          ijij += field(a, b).dot(K * field(a, b));
        }
    return {iijj, ijij};
  }

  TEST(PatchTest, ConsistentFitWithVolumeHasTheModuliOfRegularCells)
  {
    // An isotropic tensor is Cauchy's part, which springs give, plus
    // (lambda - mu) I x I, which the volume gives.
    Random random(103);
    for (const CellKind kind : all_kinds)
      for (const double nu : {0., 0.2, 0.3, 0.45, 0.49})
        {
          const auto problem = regular_problem(kind, nu);
          const auto result  = fit(problem,
                                  method_named("consistent"),
                                  options_with(Enrichment::volume, true));
          const auto K       = stiffness_of(problem, result);
          const auto wanted  = invariants(problem.points, problem.stiffness);
          const auto found   = invariants(problem.points, K);
          // Up to the next rung's weight in relation to this one's, squared,
          // times what the tetrahedron leaves there.
          EXPECT_NEAR(found.first, wanted.first, 1e-3 * wanted.first);
          EXPECT_NEAR(found.second, wanted.second, 1e-3 * wanted.second);

          // The edges of a regular tetrahedron are the face diagonals of a
          // cube, whose springs are cubic, not isotropic. The others are
          // isotropic, up to 1 / weight^2 of what comes after.
          if (kind == CellKind::tetrahedron)
            continue;
          const Eigen::VectorXd u = random_strain_field(problem.points, random);
          EXPECT_NEAR(u.dot(K * u),
                      u.dot(problem.stiffness * u),
                      1e-5 * u.dot(problem.stiffness * u));
        }
  }

  /** Regular but @p ratio times as long along the first axis. */
  FitProblem
  brick_problem(const CellKind kind, const double ratio, const double nu)
  {
    Eigen::MatrixXd x = regular_cell(kind);
    x.row(0) *= ratio;
    return fit_problem(x, kind, nu);
  }

  TEST(PatchTest, BricksAreIsotropicUpToTheSquareRootOfThree)
  {
    // Of springs alone C_1212 comes from the diagonals, and with it their part
    // of C_1111, C_1212 times the square of the ratio, which must leave room
    // for springs along the brick: at most the isotropic 3 C_1212.
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      for (const double nu : {0.1, 0.3, 0.45})
        for (const double ratio : {1.3, 1.7, 1.77, 2.5})
          {
            const auto problem = brick_problem(kind, ratio, nu);
            const auto E =
              residual(problem,
                       fit(problem,
                           method_named("consistent"),
                           options_with(Enrichment::volume, true)));
            const Eigen::MatrixXd M = affine_basis(problem.points);
            const double missed =
              (M.transpose() * E * M).norm() /
              (M.transpose() * problem.stiffness * M).norm();
            if (ratio < std::sqrt(3.))
              EXPECT_LT(missed, 1e-4) << ratio;
            else
              EXPECT_GT(missed, 1e-3) << ratio;
          }
  }

  TEST(PatchTest, SpringsAloneTakeTheMeanOfTheModuli)
  {
    // Of springs C_iijj = C_ijij, and the consistent fit weighs both alike.
    for (const CellKind kind : all_kinds)
      {
        const auto problem = regular_problem(kind, 0.3);
        const auto K       = stiffness_of(problem,
                                    fit(problem,
                                        method_named("consistent"),
                                        options_with(Enrichment::none, true)));
        const auto wanted  = invariants(problem.points, problem.stiffness);
        const auto found   = invariants(problem.points, K);
        EXPECT_NEAR(found.first, found.second, 1e-12 * found.second);
        // Up to the next rung's weight in relation to this one's, squared.
        EXPECT_NEAR(found.second,
                    0.5 * (wanted.first + wanted.second),
                    0.01 * found.second);
      }
  }

  TEST(PatchTest, AnglesAreExactOnTriangles)
  {
    // Three lengths and three angles span the six numbers of a symmetric
    // matrix on the three deformations.
    Random random(104);
    for (unsigned int cell = 0; cell < 20; ++cell)
      {
        const auto problem = oracle::random_problem(CellKind::triangle, random);
        for (const Method &method : fits_of_a_matrix)
          EXPECT_LT(patch_residual(problem,
                                   fit(problem,
                                       method,
                                       options_with(Enrichment::angles, false)),
                                   random),
                    1e-6);
      }
  }

  TEST(PatchTest, ConsistentFitIsNearerThanTheOthers)
  {
    Random random(105);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      for (const Enrichment enrichment : {Enrichment::none, Enrichment::volume})
        {
          double sums[3] = {0., 0., 0.};
          for (unsigned int cell = 0; cell < 20; ++cell)
            {
              const Eigen::MatrixXd x = regular_cell(kind);
              const auto problem =
                fit_problem(x + 0.03 * random.matrix(x.rows(), x.cols()),
                            kind,
                            0.3);
              const auto options     = options_with(enrichment, true);
              const Method methods[] = {method_named("consistent"),
                                        method_named("frobenius"),
                                        method_named("block")};
              for (int m = 0; m < 3; ++m)
                {
                  const auto E =
                    residual(problem, fit(problem, methods[m], options));
                  const Eigen::MatrixXd M = affine_basis(problem.points);
                  sums[m] += (E * M).norm() / problem.stiffness.norm();
                }
            }
          // With a volume the regular cell is exact, and what is left is of
          // the order of the distortion.
          const double factor = enrichment == Enrichment::volume ? 3. : 1.;
          EXPECT_LT(factor * sums[0], sums[1]);
          EXPECT_LT(factor * sums[0], sums[2]);
        }
  }

  TEST(PatchTest, SpectralNormOfAConsistentFitIsCertified)
  {
    Random random(106);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      for (const Engine engine : all_engines)
        {
          auto options      = options_with(Enrichment::volume, true);
          options.norm      = Norm::spectral;
          options.engine    = engine;
          const auto result = fit(oracle::random_problem(kind, random),
                                  method_named("consistent"),
                                  options);
          ASSERT_TRUE(result.duality_gap);
          EXPECT_LT(*result.duality_gap, 1e-6);
          EXPECT_GE(result.k().minCoeff(), 0.);
        }
  }


  // Definiteness.

  TEST(Definiteness, NonnegativeCellsResistEveryDeformation)
  {
    Random random(107);
    unsigned int n_negative_volumes = 0, n_negative_angles = 0;
    for (const CellKind kind : all_kinds)
      for (const Method &method : fits_of_a_matrix)
        for (const Enrichment enrichment : all_enrichments)
          for (unsigned int cell = 0; cell < 10; ++cell)
            {
              const auto problem = slender_problem(kind, random);
              const auto result =
                fit(problem, method, options_with(enrichment, true));
              const Eigen::MatrixXd Q = deformation_basis(problem.points);
              const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
                Q.transpose() * stiffness_of(problem, result) * Q);
              const double size = spectral_norm(problem.stiffness);
              EXPECT_GE(eigen.eigenvalues()[0], -1e-9 * size);
              EXPECT_NEAR(result.smallest_eigenvalue.value(),
                          eigen.eigenvalues()[0] / size,
                          1e-12);
              EXPECT_GE(result.k().minCoeff(), 0.);
              n_negative_volumes +=
                (constants_of(result, "volumes").array() < 0.).count();
              n_negative_angles +=
                (constants_of(result, "angles").array() < 0.).count();
            }
    // It is no matter of course.
    EXPECT_GT(n_negative_volumes, 5u);
    EXPECT_GT(n_negative_angles, 50u);
  }

  TEST(Definiteness, ConsistentFitsOfBricksHaveNoMechanisms)
  {
    Random random(110);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      for (const Enrichment enrichment : {Enrichment::none, Enrichment::volume})
        for (const double ratio : {1., 1.5, 2., 4., 10.})
          {
            const auto problem = brick_problem(kind, ratio, random(0.25, 0.49));
            const auto result  = fit(problem,
                                    method_named("consistent"),
                                    options_with(enrichment, true));
            const Eigen::MatrixXd Q = deformation_basis(problem.points);
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_reference(
              Q.transpose() * problem.stiffness * Q);
            EXPECT_GT(*result.smallest_eigenvalue,
                      0.02 * of_reference.eigenvalues()[0] /
                        spectral_norm(problem.stiffness));
          }
  }

  TEST(Definiteness, AFreeCellMayReleaseEnergyAndSaysSo)
  {
    Random random(108);
    unsigned int n_indefinite = 0;
    for (unsigned int cell = 0; cell < 50; ++cell)
      n_indefinite += fit(slender_problem(CellKind::tetrahedron, random),
                          method_named("frobenius"),
                          options_with(Enrichment::angles, false))
                        .smallest_eigenvalue.value() < -1e-6;
    EXPECT_GT(n_indefinite, 0u);
    EXPECT_LT(n_indefinite, 50u);
  }


  // Degenerate coordinates.

  TEST(Degenerate, AVolumeOfZeroIsRefused)
  {
    auto problem = regular_problem(CellKind::tetrahedron, 0.3);
    problem.points.row(2).setZero();
    EXPECT_THROW(fit(problem,
                     method_named("frobenius"),
                     options_with(Enrichment::volume, true)),
                 RunError);
  }

  TEST(Degenerate, AStraightAngleIsRefused)
  {
    auto problem = regular_problem(CellKind::quadrilateral, 0.3);
    problem.points.col(3) =
      0.5 * (problem.points.col(1) + problem.points.col(2));
    EXPECT_THROW(fit(problem,
                     method_named("frobenius"),
                     options_with(Enrichment::angles, true)),
                 RunError);
  }


  // Invariance: every constant belongs to the cell, not to its place.

  TEST(Invariance, OfEnrichedCellsUnderMotions)
  {
    Random random(109);
    for (const CellKind kind : all_kinds)
      for (const Method &method : fits_of_a_matrix)
        for (const Enrichment enrichment : all_enrichments)
          {
            const Eigen::MatrixXd x = oracle::random_cell(kind, random);
            const Eigen::MatrixXd y =
              (random.rotation(x.rows()) * x).colwise() +
              Eigen::VectorXd(random.matrix(x.rows(), 1));
            const auto options = options_with(enrichment, true);
            const auto a =
              fit(oracle::fit_problem(x, kind, 0.4), method, options);
            const auto b =
              fit(oracle::fit_problem(y, kind, 0.4), method, options);
            const double tolerance = method.word == "spectral" ? 1e-5 : 1e-8;
            EXPECT_LT((a.k() - b.k()).norm(), tolerance);
            for (const std::string word : {"volumes", "angles"})
              {
                const Eigen::VectorXd of_a = constants_of(a, word);
                const Eigen::VectorXd of_b = constants_of(b, word);
                ASSERT_EQ(of_a.size(), of_b.size());
                EXPECT_LT((of_a - of_b).norm(), tolerance);
              }
          }
  }
} // namespace
