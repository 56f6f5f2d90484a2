#include <springfit/calibration/shape_quality.h>
#include <springfit/comparison/errors.h>
#include <springfit/comparison/homogenised_tensor.h>
#include <springfit/comparison/slab_share.h>
#include <springfit/core/error.h>
#include <springfit/output/csv.h>
#include <springfit/response/rigid_motion.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/volume.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>

#include "../unit/cells.h"

using namespace springfit;

namespace
{
  SpringNetwork
  cell_network(const CellKind kind, const Eigen::VectorXd &k)
  {
    const Eigen::MatrixXd points = oracle::regular_cell(kind);
    NetworkBuilder builder(points);
    std::vector<unsigned int> vertices(points.cols());
    for (unsigned int v = 0; v < vertices.size(); ++v)
      vertices[v] = v;
    builder.add(
      lengths_at_rest(points, node_pairs(kind), k, SpringLaw::quadratic),
      vertices);
    return builder.build();
  }

  /** The elasticity tensor of lambda and mu as homogenised_tensor orders it. */
  ElasticityTensor
  isotropic_tensor(const int dim, const double lambda, const double mu)
  {
    ElasticityTensor C = ElasticityTensor::Zero(dim * dim, dim * dim);
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        for (int k = 0; k < dim; ++k)
          for (int l = 0; l < dim; ++l)
            C(dim * i + j, dim * k + l) =
              lambda * (i == j) * (k == l) +
              mu * ((i == k) * (j == l) + (i == l) * (j == k));
    return C;
  }
} // namespace

TEST(Errors, AreRelativeToTheLargestDisplacementOverAllNodes)
{
  Eigen::MatrixXd reference(2, 3), model(2, 3);
  reference << 0., 3., 0., //
    0., 4., 1.;
  model << 0., 3., 0., //
    0., 3., 3.;
  const auto norms = error_norms(reference, model);
  EXPECT_DOUBLE_EQ(norms.e_max_percent, 100. * 2. / 5.);
  EXPECT_DOUBLE_EQ(norms.e_rms_percent, 100. * std::sqrt(5. / 3.) / 5.);
}

TEST(HomogenisedTensor, HasTheEnergyOfAffineDeformation)
{
  oracle::Random random(7);
  for (const CellKind kind : oracle::all_kinds)
    {
      const int dim           = dimension(kind);
      const auto &pairs       = node_pairs(kind);
      const Eigen::VectorXd k = random.matrix(pairs.size(), 1).array() + 2.;
      const auto network      = cell_network(kind, k);
      const double volume     = 0.7;
      const auto C            = homogenised_tensor(network, volume);
      const Eigen::MatrixXd G = random.matrix(dim, dim);
      double energy           = 0.;
      for (std::size_t s = 0; s < pairs.size(); ++s)
        {
          const Eigen::VectorXd d =
            network.nodes.col(pairs[s][1]) - network.nodes.col(pairs[s][0]);
          energy += k[s] * std::pow(d.dot(G * d) / d.norm(), 2);
        }
      const Eigen::MatrixXd Gt = G.transpose(); // row i of G one after another
      const Eigen::Map<const Eigen::VectorXd> g(Gt.data(), dim * dim);
      EXPECT_NEAR(volume * g.dot(C * g), energy, 1e-12 * energy);
    }
}

TEST(HomogenisedTensor, ObeysCauchysRelations)
{
  // nu = 1/4 in space and 1/3 in plane stress, whatever the springs.
  oracle::Random random(8);
  for (const CellKind kind : oracle::all_kinds)
    {
      const Eigen::VectorXd k =
        random.matrix(node_pairs(kind).size(), 1).array() + 1.5;
      const auto part =
        isotropic_part(homogenised_tensor(cell_network(kind, k), 1.));
      EXPECT_NEAR(part.lambda, part.mu, 1e-12 * part.mu);
      if (dimension(kind) == 3)
        EXPECT_NEAR(young_poisson(part.lambda, part.mu).poissons_ratio,
                    0.25,
                    1e-12);
      else
        EXPECT_NEAR(
          young_poisson_plane_stress(part.lambda, part.mu).poissons_ratio,
          1. / 3.,
          1e-12);
    }
}

TEST(HomogenisedTensor, HasTheEnergyOfCouplingsAnglesAndVolumes)
{
  oracle::Random random(10);
  for (const CellKind kind : oracle::all_kinds)
    {
      const int dim                = dimension(kind);
      const Eigen::MatrixXd points = oracle::random_cell(kind, random);
      const auto &pairs            = node_pairs(kind);
      std::vector<unsigned int> vertices(points.cols());
      std::iota(vertices.begin(), vertices.end(), 0);
      const double V0 = volume(points, kind);
      NetworkBuilder builder(points);
      builder.add(couplings_at_rest(points,
                                    pairs,
                                    {{0, 1, 3.}, {0, 2, -1.}},
                                    SpringLaw::quadratic),
                  vertices);
      builder.add(angles_at_rest(points,
                                 {{{1, 0, 2}}},
                                 Eigen::VectorXd::Constant(1, 2.)),
                  vertices);
      builder.add(volume_at_rest(points, kind, 5.), vertices);
      const auto network = builder.build();
      const auto angle   = [](const Eigen::MatrixXd &x) {
        return std::acos((x.col(1) - x.col(0))
                           .normalized()
                           .dot((x.col(2) - x.col(0)).normalized()));
      };

      // The second difference of the energy under x -> x + t G x.
      const Eigen::MatrixXd G = random.matrix(dim, dim);
      const auto energy       = [&](const double t) {
        const Eigen::MatrixXd x = points + t * G * points;
        const auto elongation   = [&](const unsigned int s) {
          const auto [i, j] = pairs[s];
          return (x.col(j) - x.col(i)).norm() -
                 (points.col(j) - points.col(i)).norm();
        };
        const double growth  = volume(x, kind) - V0;
        const double opening = angle(x) - angle(points);
        return 3. * elongation(0) * elongation(1) -
               elongation(0) * elongation(2) + opening * opening +
               5. * growth * growth / 2.;
      };
      const double h           = 1e-4;
      const double curvature   = (energy(h) + energy(-h)) / (h * h);
      const auto C             = homogenised_tensor(network, 0.7);
      const Eigen::MatrixXd Gt = G.transpose();
      const Eigen::Map<const Eigen::VectorXd> g(Gt.data(), dim * dim);
      EXPECT_NEAR(0.7 * g.dot(C * g), curvature, 1e-5);
    }
}

TEST(HomogenisedTensor, LloydsTriangleIsTheMaterial)
{
  // Lloyd, Szekely and Harders 2007: k = sqrt(3)/4 E h at nu = 1/3.
  const auto network =
    cell_network(CellKind::triangle,
                 Eigen::Vector3d::Constant(std::sqrt(3.) / 4.));
  const auto part =
    isotropic_part(homogenised_tensor(network, std::sqrt(3.) / 4.));
  const auto constants = young_poisson_plane_stress(part.lambda, part.mu);
  EXPECT_NEAR(constants.youngs_modulus, 1., 1e-12);
  EXPECT_NEAR(constants.poissons_ratio, 1. / 3., 1e-12);
  EXPECT_NEAR(part.anisotropy, 0., 1e-12);
}

TEST(IsotropicPart, RecoversLameConstants)
{
  for (const int dim : {2, 3})
    {
      const auto part = isotropic_part(isotropic_tensor(dim, 1.7, 0.6));
      EXPECT_NEAR(part.lambda, 1.7, 1e-13);
      EXPECT_NEAR(part.mu, 0.6, 1e-13);
      EXPECT_NEAR(part.anisotropy, 0., 1e-13);
    }
}

TEST(IsotropicPart, IsTheNearest)
{
  oracle::Random random(9);
  Eigen::MatrixXd C   = random.matrix(9, 9);
  C                   = C * C.transpose();
  const auto part     = isotropic_part(C);
  const auto distance = [&](const double lambda, const double mu) {
    return (C - isotropic_tensor(3, lambda, mu)).norm();
  };
  const double nearest = distance(part.lambda, part.mu);
  EXPECT_NEAR(part.anisotropy, nearest / C.norm(), 1e-12);
  for (const double step : {-1e-3, 1e-3})
    {
      EXPECT_GT(distance(part.lambda + step, part.mu), nearest);
      EXPECT_GT(distance(part.lambda, part.mu + step), nearest);
    }
}

TEST(YoungPoisson, InvertsTheLameConstants)
{
  const double E = 3., nu = 0.42, mu = E / (2. * (1. + nu));
  auto constants = young_poisson(E * nu / ((1. + nu) * (1. - 2. * nu)), mu);
  EXPECT_NEAR(constants.youngs_modulus, E, 1e-12);
  EXPECT_NEAR(constants.poissons_ratio, nu, 1e-12);
  constants = from_plane_strain({E / (1. - nu * nu), nu / (1. - nu)});
  EXPECT_NEAR(constants.youngs_modulus, E, 1e-12);
  EXPECT_NEAR(constants.poissons_ratio, nu, 1e-12);
  constants = young_poisson_plane_stress(E * nu / (1. - nu * nu), mu);
  EXPECT_NEAR(constants.youngs_modulus, E, 1e-12);
  EXPECT_NEAR(constants.poissons_ratio, nu, 1e-12);
}

TEST(SlabShare, OfASimplexHasItsClosedForm)
{
  // The part of the unit tetrahedron with z below s is 1 - (1 - s)^3; three
  // heights are equal.
  for (const double s : {-0.1, 0., 0.3, 0.8, 1., 1.2})
    EXPECT_NEAR(simplex_share_below({0., 1., 0., 0.}, s),
                1. - std::pow(1. - std::clamp(s, 0., 1.), 3),
                1e-14);
  // x + y on the unit square's triangle below the diagonal.
  EXPECT_NEAR(simplex_share_below({0., 1., 1.}, 0.5), 0.25, 1e-14);
  EXPECT_EQ(simplex_share_below({2., 2., 2.}, 2.5), 1.);
  EXPECT_EQ(simplex_share_below({2., 2., 2.}, 1.5), 0.);
}

TEST(SlabShare, AgreesWithCountingPoints)
{
  oracle::Random random(10);
  for (int repetition = 0; repetition < 5; ++repetition)
    {
      Eigen::MatrixXd points =
        oracle::random_cell(CellKind::tetrahedron, random);
      const Eigen::Vector3d axis =
        Eigen::Vector3d(random.matrix(3, 1)).normalized();
      const Eigen::RowVectorXd heights = axis.transpose() * points;
      const double lowest              = heights.minCoeff() + 0.2 * random();
      const double highest             = lowest + 0.3;
      const int n                      = 200000;
      int inside                       = 0;
      for (int p = 0; p < n; ++p)
        {
          // Barycentric coordinates that are uniform on the simplex.
          Eigen::Vector4d weights;
          for (int v = 0; v < 4; ++v)
            weights[v] = -std::log(1. - random());
          const double height = heights.dot(weights) / weights.sum();
          inside += height >= lowest && height <= highest;
        }
      EXPECT_NEAR(
        slab_share(points, CellKind::tetrahedron, axis, lowest, highest),
        static_cast<double>(inside) / n,
        0.005);
    }
}

TEST(SlabShare, OfABoxIsThatOfItsExtent)
{
  for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
    {
      const Eigen::MatrixXd points = oracle::regular_cell(kind);
      const Eigen::VectorXd axis =
        Eigen::VectorXd::Unit(points.rows(), points.rows() - 1);
      EXPECT_NEAR(slab_share(points, kind, axis, 0.3, 2.), 0.7, 1e-14);
      EXPECT_NEAR(slab_share(points, kind, axis, 0.3, 0.4), 0.1, 1e-14);
      EXPECT_NEAR(slab_share(points, kind, axis, 1.3, 1.4), 0., 1e-14);
    }
}

TEST(SlabShare, OfASurfaceIsThatOfItsArea)
{
  // A right triangle that stands on end: half as high it has a quarter of its
  // area above.
  Eigen::Matrix3d points;
  points << 0., 1., 0., //
    0., 1., 0.,         //
    0., 0., 2.;
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(slab_share(points, CellKind::triangle, z, 1., 2.), 0.25, 1e-14);
  EXPECT_NEAR(slab_share(points, CellKind::triangle, z, 0., 1.), 0.75, 1e-14);
}

namespace
{
  /** Of nodes that are held in all components. */
  std::string
  motion_left(const Eigen::MatrixXd &points)
  {
    return free_rigid_motion(
      points, HeldComponents::Constant(points.rows(), points.cols(), true));
  }
} // namespace

TEST(RigidMotion, IsNamed)
{
  EXPECT_NE(motion_left(Eigen::MatrixXd(3, 0)), "");
  EXPECT_NE(motion_left(Eigen::Vector3d(1., 2., 3.)).find("(1, 2, 3)"),
            std::string::npos);
  Eigen::MatrixXd line(3, 3);
  line << 0., 1., 3., //
    0., 0., 0.,       //
    5., 5., 5.;
  EXPECT_NE(motion_left(line).find("axis"), std::string::npos);
  line(1, 2) = 1e-3; // no longer on a line
  EXPECT_EQ(motion_left(line), "");

  EXPECT_NE(motion_left(Eigen::Vector2d(1., 2.)), "");
  Eigen::MatrixXd two(2, 2);
  two << 0., 1., 0., 0.;
  EXPECT_EQ(motion_left(two), "");
  two.col(1) = two.col(0); // the same node twice
  EXPECT_NE(motion_left(two), "");
}

TEST(RigidMotion, IsLeftBySlidingSupports)
{
  // The corners of a square in the plane z = 0.
  Eigen::MatrixXd corners(3, 4);
  corners << 0., 1., 0., 1., //
    0., 0., 1., 1.,          //
    0., 0., 0., 0.;
  HeldComponents held = HeldComponents::Constant(3, 4, false);
  held.row(2)         = true;
  held(0, 0) = held(1, 0) = true;
  EXPECT_NE(free_rigid_motion(corners, held)
              .find("axis through (0, 0, 0) m along (0, 0, 1)"),
            std::string::npos)
    << free_rigid_motion(corners, held);
  held(1, 1) = true;
  EXPECT_EQ(free_rigid_motion(corners, held), "");
  held(0, 0) = false;
  EXPECT_EQ(free_rigid_motion(corners, held),
            "the translation along (1, 0, 0)");

  // In the plane: rollers whose normals meet in the origin.
  Eigen::MatrixXd rollers(2, 3);
  rollers << 2., 0., 0., //
    0., 3., 4.;
  HeldComponents normal = HeldComponents::Constant(2, 3, false);
  normal(0, 0) = normal(1, 1) = normal(1, 2) = true;
  EXPECT_EQ(free_rigid_motion(rollers, normal),
            "the rotation about the point (0, 0) m");
  normal(0, 2) = true;
  EXPECT_EQ(free_rigid_motion(rollers, normal), "");
}

TEST(ShapeQuality, IsOneForRegularCellsAndZeroForFlatOnes)
{
  for (const CellKind kind : oracle::all_kinds)
    {
      Eigen::MatrixXd points = oracle::regular_cell(kind);
      EXPECT_NEAR(shape_quality(points, kind), 1., 1e-14);
      points.row(points.rows() - 1) *= 1e-9;
      if (is_simplex(kind))
        EXPECT_LT(shape_quality(points, kind), 1e-8);
      points = oracle::regular_cell(kind);
      points.row(0) *= -1.;
      EXPECT_NEAR(shape_quality(points, kind), -1., 1e-14); // mirrored
    }
}

TEST(CsvTable, RefusesWhatIsNotFiniteAndKeepsDoubles)
{
  CsvTable table("a,b");
  table.new_row();
  EXPECT_THROW(table << std::numeric_limits<double>::quiet_NaN(), RunError);
  EXPECT_THROW(table.exactly(std::numeric_limits<double>::infinity()),
               RunError);

  CsvTable exact("i,x");
  const double number = 0.1 + 0.2;
  exact.new_row();
  exact << 7u;
  exact.exactly(number);
  const auto path =
    std::filesystem::temp_directory_path() / "springfit_csv_test.csv";
  exact.write(path);
  std::ifstream file(path);
  std::string header, row;
  std::getline(file, header);
  std::getline(file, row);
  EXPECT_EQ(header, "i,x");
  EXPECT_EQ(std::stod(row.substr(row.find(',') + 1)), number);
  std::filesystem::remove(path);
}
