#include <springfit/core/error.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/point_volumes.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/volumes.h>

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  // Invariance: k belongs to the spring, not to coordinates or numbers.

  double
  tolerance_of(const Method &method)
  {
    return method.word == "spectral" ? 1e-6 : 1e-12;
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
       const Method &method,
       const FitOptions &options)
  {
    return fit(oracle::fit_problem(x, kind, 0.3), method, options).k();
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
          const Eigen::VectorXd k  = result.k();
          for (int s = 0; s < k.size(); ++s)
            E -= k[s] * problem.gradients.col(s) *
                 problem.gradients.col(s).transpose();
          EXPECT_NEAR(result.frobenius_residual, E.norm() / R.norm(), 1e-12);
          // The largest singular value, by another algorithm.
          EXPECT_NEAR(
            result.spectral_residual,
            Eigen::JacobiSVD<Eigen::MatrixXd>(E).singularValues()[0] /
              Eigen::JacobiSVD<Eigen::MatrixXd>(R).singularValues()[0],
            1e-10);
          EXPECT_EQ(result.duality_gap.has_value(), method.word == "spectral");
        }
  }

  TEST(Fit, EachMethodIsTheBestInItsNorm)
  {
    Random random(31);
    for (const CellKind kind : all_kinds)
      for (const bool nonnegative : {false, true})
        {
          const auto problem = slender_problem(kind, random);
          const auto options = options_of(Engine::ipopt, nonnegative);
          const auto block   = fit(problem, method_named("block"), options);
          const auto frobenius =
            fit(problem, method_named("frobenius"), options);
          const auto spectral = fit(problem, method_named("spectral"), options);
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
              EXPECT_GE(result.k().minCoeff(), 0.);
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
                       oracle::simplex_stiffness(x, oracle::plane_strain(0.25)),
                       isotropic_material(2, 0.4, 0.4, 1.));
    for (const auto &[method, options] : all_fits())
      EXPECT_LT(fit(problem, method, options).spectral_residual, 1e-8);
  }

  TEST(Fit, WhatIsNoStiffnessIsRefused)
  {
    auto problem = regular_problem(CellKind::triangle, 0.3);
    problem.stiffness.setZero();
    EXPECT_THROW(fit(problem, method_named("frobenius"), {}), RunError);
    problem.stiffness(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(fit(problem, method_named("spectral"), {}), RunError);
  }

  /** Their equations are nearly singular: the flattest ones take many
   * corrections. */
  TEST(Fit, ComplianceOfFlatTetrahedra)
  {
    FitOptions options;
    options.enrichment  = Enrichment::angles;
    options.nonnegative = true;
    for (const double nu : {0., 0.1, 0.3, 0.45})
      for (const double height : {0.1, 0.03, 0.01})
        {
          Eigen::MatrixXd points = oracle::regular_cell(CellKind::tetrahedron);
          points.row(2) *= height / points.row(2).maxCoeff();
          const auto problem =
            oracle::fit_problem(points, CellKind::tetrahedron, nu);
          const auto found = fit(problem, method_named("compliance"), options);
          EXPECT_EQ(found.n_negative, 0u);
          EXPECT_GE(*found.smallest_eigenvalue, -1e-10);
        }
  }


  // Models between two others.

  /** What one of them lacks counts as zero. */
  TEST(CellModel, BetweenTwoOthersHasTheMeanOfTheirEnergies)
  {
    Random random(33);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      {
        const auto problem       = oracle::random_problem(kind, random);
        const Eigen::MatrixXd &x = problem.points;
        const auto springs       = [&] {
          return lengths_at_rest(x,
                                 problem.springs,
                                 random.matrix(problem.springs.size(), 1),
                                 SpringLaw::quadratic);
        };
        std::vector<unsigned int> vertices(x.cols());
        std::iota(vertices.begin(), vertices.end(), 0);
        const auto of_points = [&] {
          Family family(point_volumes(kind));
          const Eigen::VectorXd k = random.matrix(x.cols(), 1);
          family.add(vertices,
                     {{k.begin(), k.end()},
                      std::vector<double>(x.cols(), 0.1)});
          return family;
        };
        const CellModel a{{springs(), of_points()}};
        const CellModel b{
          {of_points(), springs(), volume_at_rest(x, kind, 2.)}};
        const double t     = 0.3;
        const CellModel ab = between(a, b, t);
        EXPECT_EQ(ab.families.size(), 3u);
        EXPECT_LT((ab.k() - ((1. - t) * a.k() + t * b.k())).norm(), 1e-15);
        for (int repetition = 0; repetition < 5; ++repetition)
          {
            const Eigen::MatrixXd y =
              x + 0.1 * random.matrix(x.rows(), x.cols());
            EXPECT_NEAR(energy(ab.families, y),
                        (1. - t) * energy(a.families, y) +
                          t * energy(b.families, y),
                        1e-14);
          }
        EXPECT_EQ(energy(between(a, b, 0.).families, x), energy(a.families, x));

        // There is no stiffness to take the mean of.
        Family logarithmic(logarithmic_volumes(kind));
        logarithmic.add(vertices, {{1.}, {1.}, {1.}});
        EXPECT_THROW(between({{logarithmic}}, {{logarithmic}}, t),
                     std::logic_error);
      }
  }


  TEST(Fit, IsTheSameInEveryUnit)
  {
    // Micrometres and kilometres, gels and steel; what is left is rounding.
    for (const CellKind kind : all_kinds)
      for (const auto &[method, word] : method_words())
        for (const auto &[enrichment, name] : enrichment_words())
          for (const bool nonnegative : {false, true})
            {
              if (!suits(*method, kind) || !suits(*method, enrichment))
                continue;
              Random random(7);
              const Eigen::MatrixXd points = random_cell(kind, random);
              const double nu              = random(0., 0.45);
              FitOptions options     = options_of(Engine::ipopt, nonnegative);
              options.enrichment     = enrichment;
              const auto residual_of = [&](const double size,
                                           const double modulus) {
                const Eigen::MatrixXd x = size * points;
                return fit(make_fit_problem(
                             x,
                             kind,
                             stiffness(x,
                                       kind,
                                       modulus * usual_elasticity(kind, nu)),
                             {modulus, nu, 1.}),
                           *method,
                           options)
                  .spectral_residual;
              };
              const double usual = residual_of(1., 1.);
              for (const auto &[size, modulus] :
                   {std::pair{1e-6, 1e-3}, std::pair{1e3, 1e12}})
                EXPECT_NEAR(residual_of(size, modulus), usual, 2e-10)
                  << word << ' ' << name;
            }
  }


  TEST(Fit, Words)
  {
    EXPECT_EQ(words_of(method_words()),
              (std::vector<std::string>{"block",
                                        "frobenius",
                                        "spectral",
                                        "consistent",
                                        "compliance",
                                        "stable neo-hookean",
                                        "gelder",
                                        "lloyd",
                                        "baudet",
                                        "delingette",
                                        "golec"}));
    EXPECT_EQ(words_of(engine_words()),
              (std::vector<std::string>{"ipopt", "barrier"}));
  }
} // namespace
