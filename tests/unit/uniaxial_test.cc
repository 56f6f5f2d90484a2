#include <springfit/comparison/uniaxial_test.h>
#include <springfit/springs/rest_families.h>

#include <gtest/gtest.h>

#include <cmath>

#include "fits.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  struct Cell
  {
    CellKind kind;
    Eigen::MatrixXd points;

    /**
     * A material without shear modulus is a fluid: its forces under u = x are
     * dim times the integrals of the shape functions' gradients.
     */
    Eigen::MatrixXd
    integrated_gradients() const
    {
      const int dim           = dimension(kind);
      const Eigen::MatrixXd D = isotropic(dim, 1., 0.);
      const Eigen::VectorXd f = stiffness(points, kind, D) * points.reshaped();
      const Eigen::MatrixXd sum = f.reshaped(dim, points.cols());
      return sum / dim;
    }

    std::optional<YoungPoisson>
    test(const Eigen::MatrixXd &K, const Eigen::VectorXd &axis) const
    {
      return uniaxial_test(K, points, integrated_gradients(), axis);
    }
  };

  Cell
  unit_cell(const CellKind kind)
  {
    return {kind, regular_cell(kind)};
  }

  Eigen::VectorXd
  x_axis(const CellKind kind)
  {
    return Eigen::VectorXd::Unit(dimension(kind), 0);
  }

  Eigen::MatrixXd
  spring_stiffness(const FitProblem &problem, const Eigen::VectorXd &k)
  {
    return problem.gradients * k.asDiagonal() * problem.gradients.transpose();
  }

  /** What a fit's springs deliver of a cell of E = 1, pulled along x. */
  YoungPoisson
  delivered(const CellKind kind,
            const double nu,
            const Method &method,
            const FitOptions &options = {})
  {
    const auto problem = regular_problem(kind, nu);
    const auto result =
      unit_cell(kind).test(spring_stiffness(problem,
                                            fit(problem, method, options).k()),
                           x_axis(kind));
    EXPECT_TRUE(result);
    return result.value_or(YoungPoisson{0., 0.});
  }
} // namespace

TEST(UniaxialTest, FiniteElementsDeliverTheirMaterial)
{
  Random random(1);
  for (const CellKind kind : all_kinds)
    for (const double nu : {-0.3, 0., 0.3, 0.45})
      for (int repetition = 0; repetition < 5; ++repetition)
        {
          const int dim              = dimension(kind);
          const Cell cell            = {kind, 0.02 * random_cell(kind, random)};
          const Eigen::VectorXd axis = random.matrix(dim, 1).normalized();
          const double E             = 1e4;

          const auto usual = cell.test(
            E * stiffness(cell.points, kind, usual_elasticity(kind, nu)), axis);
          ASSERT_TRUE(usual);
          EXPECT_NEAR(usual->youngs_modulus, E, 1e-10 * E) << singular(kind);
          EXPECT_NEAR(usual->poissons_ratio, nu, 1e-10) << singular(kind);

          if (dim == 3)
            continue;
          const auto strain =
            cell.test(E * stiffness(cell.points, kind, plane_strain(nu)), axis);
          ASSERT_TRUE(strain);
          const auto material = from_plane_strain(*strain);
          EXPECT_NEAR(material.youngs_modulus, E, 1e-10 * E) << singular(kind);
          EXPECT_NEAR(material.poissons_ratio, nu, 1e-10) << singular(kind);
        }
}

TEST(UniaxialTest, ThicknessCancels)
{
  const CellKind kind = CellKind::quadrilateral;
  const Cell cell     = unit_cell(kind);
  const auto result =
    uniaxial_test(0.01 * stiffness(cell.points, kind, plane_stress(0.5)),
                  cell.points,
                  0.01 * cell.integrated_gradients(),
                  x_axis(kind));
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->youngs_modulus, 1., 1e-12);
  EXPECT_NEAR(result->poissons_ratio, 0.5, 1e-12);
}

// The unit square of edge springs k_e and diagonal springs k_d has
// C_1111 = 2 k_e + k_d and C_1122 = k_d, hence nu = k_d / (2 k_e + k_d) and
// E = C_1111 (1 - nu^2). From the blocks of its stiffness, in units of
// E / (1 - nu^2): block k_e = (3 + nu) / 12, k_d = (9 + nu) / 24; frobenius
// k_e = (6 - nu) / 21, k_d = (15 + nu) / 42.
TEST(UniaxialTest, OfTheSquareInClosedForm)
{
  const CellKind kind = CellKind::quadrilateral;
  for (const double nu : {-0.5, 0., 0.3, 1. / 3., 0.45, 0.5})
    {
      const double plane = 1. - nu * nu;

      const auto block      = delivered(kind, nu, method_named("block"));
      const double nu_block = (9. + nu) / (21. + 5. * nu);
      EXPECT_NEAR(block.poissons_ratio, nu_block, 1e-12);
      EXPECT_NEAR(block.youngs_modulus,
                  (21. + 5. * nu) / 24. * (1. - nu_block * nu_block) / plane,
                  1e-12);

      const auto frobenius = delivered(kind, nu, method_named("frobenius"));
      const double nu_frobenius = (15. + nu) / (39. - 3. * nu);
      EXPECT_NEAR(frobenius.poissons_ratio, nu_frobenius, 1e-12);
      EXPECT_NEAR(frobenius.youngs_modulus,
                  (39. - 3. * nu) / 42. * (1. - nu_frobenius * nu_frobenius) /
                    plane,
                  1e-12);
    }
  // The springs of the spectral fit: the edge is 0.315934, the diagonal
  // anywhere in 0.323 .. 0.460.
  const auto spectral = delivered(kind, 0.3, method_named("spectral"));
  EXPECT_GT(spectral.poissons_ratio, 0.323 / (2. * 0.315934 + 0.323));
  EXPECT_LT(spectral.poissons_ratio, 0.460 / (2. * 0.315934 + 0.460));
}

// The unit cube of edge, face and body springs:
// C_1111 = 4 k_e + 4 k_f + 4/3 k_b, C_1122 = 2 k_f + 4/3 k_b.
TEST(UniaxialTest, OfTheCubeFromCheckedConstants)
{
  struct Checked
  {
    Method method;
    double edge, face, body;
  };
  for (const Checked &k :
       {Checked{method_named("block"), 0.106838, 0.165598, 0.138889},
        Checked{method_named("frobenius"), 0.0897436, 0.1324786, 0.0897436},
        Checked{method_named("spectral"), 0.1170690, 0.1285067, 0.1221094}})
    {
      const double C11  = 4. * k.edge + 4. * k.face + 4. / 3. * k.body;
      const double C12  = 2. * k.face + 4. / 3. * k.body;
      const auto result = delivered(CellKind::hexahedron, 0.3, k.method);
      EXPECT_NEAR(result.poissons_ratio, C12 / (C11 + C12), 2e-6);
      EXPECT_NEAR(result.youngs_modulus,
                  (C11 - C12) * (C11 + 2. * C12) / (C11 + C12),
                  5e-6);
    }
}

// Three springs make an isotropic sheet of nu = 1/3 of the triangle. The
// edges of the regular tetrahedron are cubically anisotropic: nu = 1/4 along an
// edge, and 1/3 between opposite edges (the axes of the cube around it).
TEST(UniaxialTest, OfRegularSimplices)
{
  Random random(2);
  for (const double nu : {0., 0.3, 0.45})
    for (const auto &[method, options] : all_fits())
      {
        const Cell triangle = unit_cell(CellKind::triangle);
        const auto problem  = regular_problem(CellKind::triangle, nu);
        const auto plane =
          triangle.test(spring_stiffness(problem,
                                         fit(problem, method, options).k()),
                        random.matrix(2, 1).normalized());
        ASSERT_TRUE(plane);
        EXPECT_NEAR(plane->poissons_ratio, 1. / 3., 1e-7);

        EXPECT_NEAR(
          delivered(CellKind::tetrahedron, nu, method, options).poissons_ratio,
          0.25,
          1e-7);
        const Cell solid         = unit_cell(CellKind::tetrahedron);
        const auto solid_problem = regular_problem(CellKind::tetrahedron, nu);
        const auto &x            = solid.points;
        const Eigen::VectorXd axis =
          (x.col(0) + x.col(1) - x.col(2) - x.col(3)).normalized();
        const auto between =
          solid.test(spring_stiffness(solid_problem,
                                      fit(solid_problem, method, options).k()),
                     axis);
        ASSERT_TRUE(between);
        EXPECT_NEAR(between->poissons_ratio, 1. / 3., 1e-7);
      }
}

TEST(UniaxialTest, ModulusIsProportionalToTheCells)
{
  for (const CellKind kind : all_kinds)
    for (const auto &[method, options] : all_fits())
      {
        // The engines of the spectral fit iterate on rounded figures.
        const double tolerance = method.word == "spectral" ? 1e-10 : 1e-12;
        const auto unit        = delivered(kind, 0.4, method, options);
        for (const double E : {1e-3, 10., 12345.6789, 1e11})
          {
            auto problem = regular_problem(kind, 0.4);
            problem.stiffness *= E;
            const auto result = unit_cell(kind).test(
              spring_stiffness(problem, fit(problem, method, options).k()),
              x_axis(kind));
            ASSERT_TRUE(result);
            EXPECT_NEAR(result->youngs_modulus / E,
                        unit.youngs_modulus,
                        tolerance)
              << singular(kind);
            EXPECT_NEAR(result->poissons_ratio, unit.poissons_ratio, tolerance)
              << singular(kind);
          }
      }
}

TEST(UniaxialTest, TurnsWithTheCell)
{
  Random random(3);
  for (const CellKind kind : all_kinds)
    {
      const int dim           = dimension(kind);
      const Eigen::MatrixXd x = random_cell(kind, random);
      const Eigen::MatrixXd Q = random.rotation(dim);
      const auto k_test       = [&](const Eigen::MatrixXd &points,
                              const Eigen::VectorXd &axis) {
        const auto problem = fit_problem(points, kind, 0.3);
        return Cell{kind, points}.test(
          spring_stiffness(problem,
                           Eigen::VectorXd::Ones(problem.springs.size())),
          axis);
      };
      const Eigen::VectorXd axis = random.matrix(dim, 1).normalized();
      const auto there           = k_test(x, axis);
      const auto turned          = k_test(Q * x, Q * axis);
      ASSERT_TRUE(there && turned);
      EXPECT_NEAR(turned->youngs_modulus, there->youngs_modulus, 1e-10);
      EXPECT_NEAR(turned->poissons_ratio, there->poissons_ratio, 1e-10);
    }
}

TEST(UniaxialTest, SeesAMechanism)
{
  const CellKind kind = CellKind::quadrilateral;
  const auto problem  = regular_problem(kind, 0.3);
  Eigen::VectorXd k   = Eigen::VectorXd::Ones(6);
  k[2] = k[3] = 0.; // no diagonals: the square shears freely
  const auto along =
    unit_cell(kind).test(spring_stiffness(problem, k), x_axis(kind));
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->youngs_modulus, 2., 1e-12);
  EXPECT_NEAR(along->poissons_ratio, 0., 1e-12);
  EXPECT_FALSE(unit_cell(kind).test(spring_stiffness(problem, k),
                                    Eigen::Vector2d(1., 1.).normalized()));
}

TEST(AffineTensor, OfFiniteElementsIsTheirMaterials)
{
  Random random(4);
  for (const CellKind kind : all_kinds)
    {
      const Cell cell = {kind, random_cell(kind, random)};
      const auto part = isotropic_part(affine_tensor(
        stiffness(cell.points, kind, isotropic(dimension(kind), 1.5, 0.7)),
        cell.points,
        cell.integrated_gradients()));
      EXPECT_NEAR(part.lambda, 1.5, 1e-12);
      EXPECT_NEAR(part.mu, 0.7, 1e-12);
      EXPECT_LT(part.anisotropy, 1e-12);
    }
}

TEST(AffineTensor, OfSpringsIsTheHomogenisedOne)
{
  Random random(5);
  for (const CellKind kind : all_kinds)
    {
      const Cell cell         = {kind, random_cell(kind, random)};
      const auto problem      = fit_problem(cell.points, kind, 0.3);
      const Eigen::VectorXd k = random.matrix(problem.springs.size(), 1);
      NetworkBuilder builder(cell.points);
      std::vector<unsigned int> vertices(cell.points.cols());
      for (unsigned int v = 0; v < vertices.size(); ++v)
        vertices[v] = v;
      builder.add(
        lengths_at_rest(cell.points, problem.springs, k, SpringLaw::quadratic),
        vertices);
      const auto gradients = cell.integrated_gradients();
      const double volume =
        cell.points.cwiseProduct(gradients).sum() / dimension(kind);
      const auto expected = homogenised_tensor(builder.build(), volume);
      EXPECT_LT(
        (affine_tensor(spring_stiffness(problem, k), cell.points, gradients) -
         expected)
          .norm(),
        1e-12 * expected.norm());
    }
}
