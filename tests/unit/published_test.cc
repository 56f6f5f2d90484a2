// The published fits against the fits of this program, the element's stiffness
// and the materials that their authors promise.

#include <springfit/fit/cell/baudet.h>
#include <springfit/fit/cell/delingette.h>
#include <springfit/fit/cell/gelder.h>
#include <springfit/fit/cell/golec.h>
#include <springfit/fit/cell/lloyd.h>
#include <springfit/fit/cell/regularity.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/volume.h>

#include <gtest/gtest.h>

#include <stdexcept>

#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  FitOptions
  with(const Enrichment enrichment)
  {
    FitOptions options;
    options.enrichment = enrichment;
    return options;
  }

  /** A box with these sides. */
  Eigen::MatrixXd
  box(const Eigen::VectorXd &sides)
  {
    return sides.asDiagonal() * regular_cell(sides.size() == 2
                                               ? CellKind::quadrilateral
                                               : CellKind::hexahedron);
  }

  /** u = G x at every node */
  Eigen::VectorXd
  affine(const Eigen::MatrixXd &points, const Eigen::MatrixXd &G)
  {
    const Eigen::MatrixXd u = G * points;
    return Eigen::Map<const Eigen::VectorXd>(u.data(), u.size());
  }

  /**
   * The tangent of a cell's model in the affine modes, relative to its volume:
   * the tensor of a body made of such cells. Entries xx, yy, (zz), then the
   * shear strains xy, (xz, yz).
   */
  Eigen::MatrixXd
  elasticity(const FitProblem &problem, const CellModel &model)
  {
    const Eigen::MatrixXd K = problem.stiffness - residual(problem, model);
    const int dim           = problem.points.rows();
    const int n             = dim * (dim + 1) / 2;
    Eigen::MatrixXd modes(problem.points.size(), n);
    int column = 0;
    for (; column < dim; ++column)
      {
        Eigen::MatrixXd G = Eigen::MatrixXd::Zero(dim, dim);
        G(column, column) = 1.;
        modes.col(column) = affine(problem.points, G);
      }
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b, ++column)
        {
          Eigen::MatrixXd G = Eigen::MatrixXd::Zero(dim, dim);
          G(a, b)           = 1.;
          modes.col(column) = affine(problem.points, G);
        }
    return modes.transpose() * K * modes /
           (volume(problem.points, problem.kind) * problem.material.thickness);
  }

  /** Young's modulus and Poisson's ratio of a tensile test along x. */
  std::pair<double, double>
  tensile_test(const Eigen::MatrixXd &C)
  {
    const Eigen::MatrixXd S = C.inverse();
    return {1. / S(0, 0), -S(1, 0) / S(0, 0)};
  }


  TEST(Gelder, TheHypotenuseOfARightTriangle)
  {
    // Legs 3 and 4, area 6, E h = 2 * 0.5.
    Eigen::MatrixXd x(2, 3);
    x << 0., 3., 0., //
      0., 0., 4.;
    const Eigen::VectorXd k = fit_gelder(x, CellKind::triangle, {2., 0.3, 0.5});
    EXPECT_LT((k - Eigen::Vector3d(6. / 9., 6. / 16., 6. / 25.)).norm(), 1e-15);
  }

  TEST(Gelder, ARegularTetrahedron)
  {
    const Eigen::VectorXd k =
      fit_gelder(2. * regular_cell(CellKind::tetrahedron),
                 CellKind::tetrahedron,
                 {3., 0.3, 1.});
    // V = 8 sqrt(2)/12
    EXPECT_LT((k.array() - 3. * 8. * std::sqrt(2.) / 12. / 4.).matrix().norm(),
              1e-14);
  }


  TEST(Lloyd, IsTheFrobeniusFitOfRegularSimplices)
  {
    for (const CellKind kind : {CellKind::triangle, CellKind::tetrahedron})
      {
        const double nu    = dimension(kind) == 2 ? 1. / 3. : 1. / 4.;
        const auto problem = regular_problem(kind, nu);
        const auto lloyd   = fit(problem, method_named("lloyd"), {});
        const auto ours    = fit(problem, method_named("frobenius"), {});
        EXPECT_LT((lloyd.k() - ours.k()).norm(), 1e-13);
        EXPECT_NEAR(lloyd.frobenius_residual, ours.frobenius_residual, 1e-13);
      }
  }

  TEST(Lloyd, IsTheBlockFitOfTheSquare)
  {
    const auto problem = regular_problem(CellKind::quadrilateral, 1. / 3.);
    EXPECT_LT((fit(problem, method_named("lloyd"), {}).k() -
               fit(problem, method_named("block"), {}).k())
                .norm(),
              1e-14);
  }

  TEST(Lloyd, TetrahedraCountByTheirVolume)
  {
    Random random(51);
    const Eigen::MatrixXd x = random_cell(CellKind::tetrahedron, random);
    const IsotropicMaterial material{1., 0.25, 1.};
    const auto k = [&](const Eigen::MatrixXd &y) {
      return fit_lloyd(y, CellKind::tetrahedron, material)[0];
    };
    const double ratio =
      volume(x, CellKind::tetrahedron) / (std::sqrt(2.) / 12.);
    EXPECT_NEAR(k(x),
                std::cbrt(ratio) * k(regular_cell(CellKind::tetrahedron)),
                1e-14);
  }


  TEST(Baudet, SpringsDeliverTheShearModulusAndAnotherPoissonsRatio)
  {
    for (const double nu : {0., 0.2, 0.3, 0.45})
      {
        for (const double side : {1., 0.7, 1.4})
          {
            const auto problem =
              oracle::fit_problem(box(Eigen::Vector2d(1., side)),
                                  CellKind::quadrilateral,
                                  nu);
            const Eigen::MatrixXd C =
              elasticity(problem, fit(problem, method_named("baudet"), {}));
            EXPECT_NEAR(tensile_test(C).second, 1. / (3. * nu + 2.), 1e-12);
            EXPECT_NEAR(C(2, 2), 0.5 / (1. + nu), 1e-12);
          }
        const auto problem = regular_problem(CellKind::hexahedron, nu);
        const Eigen::MatrixXd C =
          elasticity(problem, fit(problem, method_named("baudet"), {}));
        EXPECT_NEAR(tensile_test(C).second, 1. / (4. * nu + 3.), 1e-12);
        for (int shear = 3; shear < 6; ++shear)
          EXPECT_NEAR(C(shear, shear), 0.5 / (1. + nu), 1e-12);
      }
  }

  TEST(Baudet, TheOneWayCorrectionMakesTheTensileTestExact)
  {
    // The authors' force: c times the axial strain acts across, nothing back.
    for (const double nu : {0., 0.2, 0.3, 0.45})
      for (const CellKind kind :
           {CellKind::quadrilateral, CellKind::hexahedron})
        {
          const int dim      = dimension(kind);
          const auto problem = regular_problem(kind, nu);
          const auto springs = fit(problem, method_named("baudet"), {});
          const auto both =
            fit(problem, method_named("baudet"), with(Enrichment::coupling));
          Eigen::MatrixXd C = elasticity(problem, springs);
          // Only the column of the axial strain, of the rows across.
          C.col(0).segment(1, dim - 1) +=
            (elasticity(problem, both) - C).col(0).segment(1, dim - 1);
          const auto [E, delivered_nu] = tensile_test(C);
          EXPECT_NEAR(E, 1., 1e-12);
          EXPECT_NEAR(delivered_nu, nu, 1e-12);
        }
  }

  TEST(Baudet, TheConservativeCorrection)
  {
    for (const double nu : {0., 0.2, 0.3, 0.45})
      {
        for (const double side : {1., 0.7, 1.4})
          {
            const auto problem =
              oracle::fit_problem(box(Eigen::Vector2d(1., side)),
                                  CellKind::quadrilateral,
                                  nu);
            const auto [E, delivered_nu] =
              tensile_test(elasticity(problem,
                                      fit(problem,
                                          method_named("baudet"),
                                          with(Enrichment::coupling))));
            EXPECT_NEAR(E, (3. * nu + 2.) * (1. - nu) / 2., 1e-12);
            EXPECT_NEAR(delivered_nu, nu, 1e-12);
          }
        const auto problem = regular_problem(CellKind::hexahedron, nu);
        const auto [E, delivered_nu] = tensile_test(elasticity(
          problem,
          fit(problem, method_named("baudet"), with(Enrichment::coupling))));
        const double expected =
          nu * (4. * nu + 3.) / (4. * nu * nu + 7. * nu + 2.);
        EXPECT_NEAR(delivered_nu, expected, 1e-12);
        EXPECT_NEAR(E,
                    (2. * nu + 1. - expected * nu * (4. * nu + 3.)) / (1. + nu),
                    1e-12);
      }
  }

  TEST(Baudet, ElongatedRectanglesHaveNegativeSprings)
  {
    // k along the long side 3: h^2 (3 nu + 2) < l^2.
    const auto problem = oracle::fit_problem(box(Eigen::Vector2d(3., 1.)),
                                             CellKind::quadrilateral,
                                             0.3);
    EXPECT_EQ(fit(problem, method_named("baudet"), {}).n_negative, 2u);
  }

  TEST(Baudet, DistortedCellsCountByTheirMeanLengths)
  {
    // A trapezium with edges 1 and 3 along x has the mean 2.
    Eigen::MatrixXd x = box(Eigen::Vector2d(2., 1.));
    x(0, 0) -= 0.5;
    x(0, 1) += 0.5;
    x(0, 2) += 0.5;
    x(0, 3) -= 0.5;
    const double slanted = std::sqrt(2.);
    const IsotropicMaterial material{1., 0.3, 1.};
    EXPECT_LT((fit_baudet(x, CellKind::quadrilateral, material) -
               fit_baudet(box(Eigen::Vector2d(2., slanted)),
                          CellKind::quadrilateral,
                          material))
                .norm(),
              1e-14);
    EXPECT_LT((fit_baudet(box(Eigen::Vector3d(0.5, 2., 1.)),
                          CellKind::hexahedron,
                          material) -
               fit_baudet(regular_cell(CellKind::hexahedron),
                          CellKind::hexahedron,
                          material))
                .norm(),
              1e-14);
  }


  TEST(Delingette, WithCouplingsIsTheElement)
  {
    Random random(52);
    for (int i = 0; i < 20; ++i)
      {
        // E and the thickness scale both sides; plane stress and strain.
        const Eigen::MatrixXd x = random_cell(CellKind::triangle, random);
        const double nu         = random(-0.5, 0.49);
        const double lambda     = nu / (1. + nu) / (1. - 2. * nu);
        const double mu         = 0.5 / (1. + nu);
        const auto stress = oracle::fit_problem(x, CellKind::triangle, nu);
        const auto strain =
          make_fit_problem(x,
                           CellKind::triangle,
                           0.01 * simplex_stiffness(x, plane_strain(nu)),
                           isotropic_material(2, lambda, mu, 0.01));
        for (const auto &problem : {stress, strain})
          {
            const auto result = fit(problem,
                                    method_named("delingette"),
                                    with(Enrichment::coupling));
            EXPECT_LT(result.frobenius_residual, 1e-13);
            EXPECT_LT(result.spectral_residual, 1e-13);
            EXPECT_EQ(constants_of(result, "couplings").size(), 3);
          }
      }
  }

  TEST(Delingette, SpringsAloneAreExactForTheTriangleThatSpringsCanBe)
  {
    const auto problem = regular_problem(CellKind::triangle, 1. / 3.);
    EXPECT_LT(fit(problem, method_named("delingette"), {}).frobenius_residual,
              1e-14);
    const auto other = regular_problem(CellKind::triangle, 0.1);
    EXPECT_GT(fit(other, method_named("delingette"), {}).frobenius_residual,
              0.01);
  }


  TEST(Golec, AtOneQuarterIsLloyd)
  {
    Random random(53);
    const auto problem =
      oracle::fit_problem(random_cell(CellKind::tetrahedron, random),
                          CellKind::tetrahedron,
                          0.25);
    const auto golec =
      fit(problem, method_named("golec"), with(Enrichment::volume));
    EXPECT_LT((golec.k() - fit(problem, method_named("lloyd"), {}).k()).norm(),
              1e-14);
    const Eigen::VectorXd of_volume = constants_of(golec, "volumes");
    ASSERT_EQ(of_volume.size(), 1);
    EXPECT_NEAR(of_volume[0], 0., 1e-13);
  }

  TEST(Golec, AffineModesOfTheRegularTetrahedron)
  {
    // A dilation by e strains the six springs by l e: with l^3 = 6 sqrt(2) V
    // their energy is 36/5 G V e^2, to which the volume adds
    // (lambda - mu) V (3 e)^2 / 2.
    for (const double nu : {0.1, 0.3, 0.45})
      {
        const double lambda = nu / (1. + nu) / (1. - 2. * nu);
        const double mu     = 0.5 / (1. + nu);
        const auto problem  = regular_problem(CellKind::tetrahedron, nu);
        const auto model =
          fit(problem, method_named("golec"), with(Enrichment::volume));
        const Eigen::MatrixXd C = elasticity(problem, model);
        EXPECT_NEAR((C.topLeftCorner<3, 3>().sum()),
                    2. * 36. / 5. * mu + 9. * (lambda - mu),
                    1e-12);
        // The volume does not resist a change of shape at constant volume:
        // there C is that of the springs.
        const CellModel springs  = springs_of(model);
        const Eigen::MatrixXd C0 = elasticity(problem, springs);
        ASSERT_EQ(springs.k(), model.k());
        ASSERT_FALSE(has_springs_alone(model.families));
        Eigen::VectorXd shape = Eigen::VectorXd::Zero(6);
        shape << 1., -0.4, -0.6, 0.3, -0.2, 0.7;
        EXPECT_LT(((C - C0) * shape).norm(), 1e-12);
      }
  }


  TEST(Published, AssumptionsOfTheirAuthors)
  {
    using Strings            = std::vector<std::string>;
    const auto square        = regular_cell(CellKind::quadrilateral);
    const auto rectangle     = box(Eigen::Vector2d(2., 1.));
    Eigen::MatrixXd rhomboid = rectangle;
    rhomboid.row(0) += 0.2 * rhomboid.row(1);
    const auto unmet =
      [&](const Method &method, const Eigen::MatrixXd &x, const double nu) {
        return unmet_assumptions(method,
                                 x,
                                 CellKind::quadrilateral,
                                 {1., nu, 1.});
      };
    EXPECT_EQ(unmet(method_named("lloyd"), square, 1. / 3.), Strings());
    EXPECT_EQ(unmet(method_named("lloyd"), rectangle, 1. / 3.),
              Strings{"squares"});
    EXPECT_EQ(unmet(method_named("lloyd"), rectangle, 0.3).size(), 2u);
    EXPECT_EQ(unmet(method_named("baudet"), rectangle, 0.3), Strings());
    EXPECT_EQ(unmet(method_named("baudet"), rhomboid, 0.3),
              Strings{"rectangles"});
    EXPECT_EQ(unmet_assumptions(method_named("baudet"),
                                box(Eigen::Vector3d(1., 1., 1.1)),
                                CellKind::hexahedron,
                                {1., 0.3, 1.}),
              Strings{"cubes"});
    EXPECT_EQ(unmet_assumptions(method_named("golec"),
                                regular_cell(CellKind::tetrahedron),
                                CellKind::tetrahedron,
                                {1., 0.2, 1.})
                .size(),
              1u);
    for (const CellKind kind : all_kinds)
      EXPECT_TRUE(is_regular(0.01 * regular_cell(kind), kind));
  }

  TEST(Published, RefusedCellsAndEnrichments)
  {
    const auto cube   = regular_problem(CellKind::hexahedron, 0.3);
    const auto square = regular_problem(CellKind::quadrilateral, 0.3);
    EXPECT_THROW(fit(cube, method_named("lloyd"), {}), std::logic_error);
    EXPECT_THROW(fit(square, method_named("gelder"), {}), std::logic_error);
    EXPECT_THROW(fit(square, method_named("baudet"), with(Enrichment::volume)),
                 std::logic_error);
  }
} // namespace
