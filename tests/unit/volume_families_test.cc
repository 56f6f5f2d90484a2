// Springs of volumes and of rest length zero, against the coordinates and the
// materials that they stand for.

#include <springfit/springs/cell_quadrature.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/network.h>
#include <springfit/springs/point_volumes.h>
#include <springfit/springs/volume.h>
#include <springfit/springs/volumes.h>
#include <springfit/springs/zero_lengths.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "cells.h"
#include "derivative.h"
#include "families.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  // Volumes.

  TEST(Volumes, AreTheCoordinateOfTheirSprings)
  {
    Random random(417);
    for (const CellKind kind : oracle::all_kinds)
      for (int repetition = 0; repetition < 20; ++repetition)
        {
          Eigen::MatrixXd x = oracle::random_cell(kind, random);
          if (repetition % 4 == 3)
            x.row(0) *= -1.; // inside out
          const double k = random(-2., 2.), rest = random(0.1, 1.);
          Family family(volumes(kind));
          family.add(first_nodes(x.cols()), {{k}, {rest}});
          const double V          = volume(x, kind);
          const Eigen::VectorXd g = volume_gradient(x, kind);
          const Eigen::MatrixXd H = volume_hessian(x, kind);
          EXPECT_NEAR(energy_of(family, x),
                      0.5 * k * (V - rest) * (V - rest),
                      1e-14);
          EXPECT_LT(
            (forces_of(family, x).reshaped() + k * (V - rest) * g).norm(),
            1e-14);
          EXPECT_LT((family.kind->hessian(family.members, 0, x) -
                     k * (g * g.transpose() + (V - rest) * H))
                      .norm(),
                    1e-14);
        }
  }

  /** Of the points, from energies k (V_g - 0)^2 / 2 and k (V_g - 1)^2 / 2. */
  Eigen::VectorXd
  volumes_at_points(const Eigen::MatrixXd &x, const CellKind cell)
  {
    const SpringKind &kind = point_volumes(cell);
    const int n            = x.cols();
    Eigen::VectorXd V(n);
    for (int g = 0; g < n; ++g)
      {
        std::vector<double> k(n, 0.);
        k[g] = 1.;
        Family at_zero(kind), at_one(kind);
        at_zero.add(first_nodes(n), {k, std::vector<double>(n, 0.)});
        at_one.add(first_nodes(n), {k, std::vector<double>(n, 1.)});
        V[g] = energy_of(at_zero, x) - energy_of(at_one, x) + 0.5;
      }
    return V;
  }

  TEST(PointVolumes, AreTheMapsDeterminantsAndSumToTheVolume)
  {
    Random random(418);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      for (int repetition = 0; repetition < 20; ++repetition)
        {
          const int dim           = dimension(kind);
          const int n             = n_vertices(kind);
          const Eigen::MatrixXd x = oracle::random_cell(kind, random);
          const Eigen::VectorXd V = volumes_at_points(x, kind);
          EXPECT_NEAR(V.sum(), volume(x, kind), 1e-14);
          for (int g = 0; g < n; ++g)
            {
              // The derivatives of the map at 1/2 (1 +- 1 / sqrt 3).
              Eigen::MatrixXd J = Eigen::MatrixXd::Zero(dim, dim);
              for (int v = 0; v < n; ++v)
                for (int d = 0; d < dim; ++d)
                  {
                    double slope = 1.;
                    for (int e = 0; e < dim; ++e)
                      {
                        const double xi =
                          0.5 + (g >> e & 1 ? 0.5 : -0.5) / std::sqrt(3.);
                        const bool upper = v >> e & 1;
                        slope *=
                          e == d ? (upper ? 1. : -1.) : (upper ? xi : 1. - xi);
                      }
                    J.col(d) += slope * x.col(v);
                  }
              EXPECT_NEAR(V[g], J.determinant() / n, 1e-14);
            }
        }
  }

  /** With all pressures equal the sum of the points is the whole. */
  TEST(PointVolumes, PushAsTheVolumeUnderAUniformPressure)
  {
    Random random(419);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const int n             = x.cols();
        const Eigen::VectorXd V = volumes_at_points(x, kind);
        std::vector<double> k(n), rest(n);
        for (int g = 0; g < n; ++g)
          {
            k[g]    = random(0.5, 1.5);
            rest[g] = V[g] - 0.7 / k[g];
          }
        Family family(point_volumes(kind));
        family.add(first_nodes(n), {k, rest});
        EXPECT_LT((forces_of(family, x).reshaped() +
                   0.7 * volume_gradient(x, kind))
                    .norm(),
                  1e-13);
      }
  }


  // The parts of the neo-Hookean material.

  /** - mu times the integrals of grad N_a . grad N_b, on all pairs. */
  Family
  shear_springs(const Eigen::MatrixXd &x, const CellKind kind, const double mu)
  {
    const int n               = x.cols();
    Eigen::MatrixXd integrals = Eigen::MatrixXd::Zero(n, n);
    for (const auto &point : cell_quadrature(kind))
      {
        const Eigen::MatrixXd J = x * point.gradients.transpose();
        const Eigen::MatrixXd gradients =
          J.inverse().transpose() * point.gradients;
        integrals +=
          point.weight * J.determinant() * gradients.transpose() * gradients;
      }
    Family family(zero_lengths(x.rows()));
    for (const auto &[a, b] : node_pairs(kind))
      family.add({a, b}, {{-mu * integrals(a, b)}, {0.}});
    return family;
  }

  TEST(ZeroLengths, HaveTheEnergyOfTheSquaredDeformationGradient)
  {
    Random random(420);
    const double mu = 0.8;
    for (const CellKind kind : oracle::all_kinds)
      for (int repetition = 0; repetition < 20; ++repetition)
        {
          const int dim           = dimension(kind);
          const Eigen::MatrixXd x = oracle::random_cell(kind, random);
          const Family family     = shear_springs(x, kind, mu);
          const Eigen::MatrixXd F = random.matrix(dim, dim);
          const Eigen::VectorXd t = random.matrix(dim, 1);
          const double expected = 0.5 * mu * volume(x, kind) * F.squaredNorm();
          EXPECT_NEAR(energy_of(family, (F * x).colwise() + t),
                      expected,
                      1e-13);

          const Eigen::MatrixXd y = random.matrix(dim, x.cols());
          const Eigen::MatrixXd z = random.matrix(dim, x.cols());
          EXPECT_LT((forces_of(family, 2. * y - 3. * z) -
                     (2. * forces_of(family, y) - 3. * forces_of(family, z)))
                      .norm(),
                    1e-12);
          EXPECT_LT((product_of(family, y, z) + forces_of(family, z)).norm(),
                    1e-13);
        }
  }

  /** Kinds of the logarithmic law, of one coordinate or of several. */
  std::vector<const SpringKind *>
  logarithmic_kinds(const CellKind cell, const bool plane_stress)
  {
    std::vector<const SpringKind *> kinds = {
      plane_stress ? &logarithmic_areas_in_plane_stress(cell)
                   : &logarithmic_volumes(cell)};
    if (!is_simplex(cell))
      kinds.push_back(plane_stress
                        ? &logarithmic_point_areas_in_plane_stress(cell)
                        : &logarithmic_point_volumes(cell));
    return kinds;
  }

  Eigen::VectorXd
  coordinates_of(const SpringKind &kind,
                 const Eigen::MatrixXd &x,
                 const CellKind cell)
  {
    if (kind.columns()[0].width == 1)
      return Eigen::VectorXd::Constant(1, volume(x, cell));
    return volumes_at_points(x, cell);
  }

  /** Of constants mu, lambda and rest volumes a member's energy is their sum.
   */
  template <typename EnergyOf>
  void
  check_logarithmic_law(const bool plane_stress, const EnergyOf &energy_of_J)
  {
    Random random(421);
    for (const CellKind cell : oracle::all_kinds)
      {
        if (plane_stress && dimension(cell) != 2)
          continue;
        for (const SpringKind *kind : logarithmic_kinds(cell, plane_stress))
          for (int repetition = 0; repetition < 10; ++repetition)
            {
              SCOPED_TRACE(name_of(*kind));
              Family family(*kind);
              family.add(first_nodes(kind->n_nodes()),
                         random_numbers(*kind, random));
              const auto &mu          = family.members.columns[0];
              const auto &lambda      = family.members.columns[1];
              const auto &rest        = family.members.columns[2];
              const Eigen::MatrixXd x = random_places(*kind, random);
              const Eigen::VectorXd V = coordinates_of(*kind, x, cell);
              double expected         = 0.;
              for (Eigen::Index g = 0; g < V.size(); ++g)
                expected +=
                  rest[g] * energy_of_J(V[g] / rest[g], mu[g], lambda[g]);
              EXPECT_NEAR(energy_of(family, x), expected, 1e-12);
            }
      }
  }

  TEST(LogarithmicVolumes, HaveTheEnergyOfTheLaw)
  {
    check_logarithmic_law(
      false, [](const double J, const double mu, const double lambda) {
        return -mu * std::log(J) + 0.5 * lambda * std::log(J) * std::log(J);
      });
  }

  /**
   * The least energy of the body over its square of the stretch across the
   * plane, by golden sections in the logarithm. For nu < 0 it is the least one
   * near rest, where the energy is convex: a sheet without thickness has none.
   */
  double
  least_energy(const double J, const double mu, const double lambda)
  {
    const double lambda_3 = 2. * mu * lambda / (2. * mu - lambda);
    const auto energy     = [&](const double log_c) {
      const double log_J = std::log(J) + 0.5 * log_c;
      return 0.5 * mu * (std::exp(log_c) - 1.) - mu * log_J +
             0.5 * lambda_3 * log_J * log_J;
    };
    const double section = 0.5 * (std::sqrt(5.) - 1.);
    double low  = lambda_3 < 0. ? std::log(-0.5 * lambda_3 / mu) : -12.;
    double high = 12.;
    while (high - low > 1e-9)
      {
        const double a = high - section * (high - low);
        const double b = low + section * (high - low);
        if (energy(a) < energy(b))
          high = b;
        else
          low = a;
      }
    return energy(0.5 * (low + high));
  }

  TEST(LogarithmicAreasInPlaneStress, HaveTheLeastEnergyOverTheThickness)
  {
    check_logarithmic_law(true, least_energy);
  }

  /** The force along the gradient of the volume is the slope of the law. */
  TEST(LogarithmicAreasInPlaneStress, PushWithTheSlopeOfTheLeastEnergy)
  {
    Random random(422);
    for (const CellKind cell : {CellKind::triangle, CellKind::quadrilateral})
      {
        const SpringKind &kind = logarithmic_areas_in_plane_stress(cell);
        for (const double J : {0.2, 0.7, 1., 1.3, 3.})
          for (const double nu : {-0.3, 0., 0.3, 0.49, 0.5})
            {
              const Eigen::MatrixXd x = oracle::random_cell(cell, random);
              const double V          = volume(x, cell);
              const double mu         = 0.5 / (1. + nu);
              const double lambda     = nu / (1. - nu * nu);
              Family family(kind);
              family.add(first_nodes(kind.n_nodes()),
                         {{mu}, {lambda}, {V / J}});
              // Under much compression such a sheet finds no thickness.
              if (nu < 0. && J < 0.5)
                {
                  EXPECT_EQ(energy_of(family, x),
                            std::numeric_limits<double>::infinity());
                  EXPECT_TRUE(forces_of(family, x).isZero(0.));
                  continue;
                }
              const auto gradient =
                [&](const Eigen::MatrixXd &y) -> Eigen::VectorXd {
                return -forces_of(family, y).reshaped();
              };
              EXPECT_LT(distance(tangent_of(family, x),
                                 derivative(gradient, x)),
                        1e-7);
              const Eigen::VectorXd g = volume_gradient(x, cell);
              const Eigen::VectorXd f = forces_of(family, x).reshaped();
              const double slope      = -f.dot(g) / g.squaredNorm();
              EXPECT_LT((f + slope * g).norm(), 1e-13);
              // Without pressure a body without Poisson's effect keeps its
              // thickness; one that keeps its volume has c = 1 / J^2.
              if (nu == 0.)
                EXPECT_NEAR(slope, -mu / J, 1e-13);
              if (nu == 0.5)
                EXPECT_NEAR(slope, -mu / (J * J * J), 1e-11);
              else
                {
                  const double h = 1e-3;
                  const auto U   = [&](const double steps) {
                    return least_energy(J + steps * h * J, mu, lambda);
                  };
                  EXPECT_NEAR(slope,
                              (8. * (U(1.) - U(-1.)) - (U(2.) - U(-2.))) /
                                (12. * h * J),
                              1e-9 / J);
                }
            }
      }
  }

  /** In plane strain, space and plane stress alike, at rest nothing pushes. */
  TEST(LogarithmicVolumes, WithZeroLengthsAreAtRestInTheShapeOfTheCell)
  {
    Random random(423);
    const double nu = 0.3, mu = 0.5 / (1. + nu);
    for (const CellKind cell : oracle::all_kinds)
      for (const bool plane_stress : {false, true})
        {
          if (plane_stress && dimension(cell) != 2)
            continue;
          const int dim           = dimension(cell);
          const double lambda     = plane_stress
                                      ? nu / (1. - nu * nu)
                                      : nu / ((1. + nu) * (1. - 2. * nu));
          const Eigen::MatrixXd x = oracle::random_cell(cell, random);
          const Family shear      = shear_springs(x, cell, mu);
          // The finest ones: the element itself.
          const SpringKind &kind =
            *logarithmic_kinds(cell, plane_stress).back();
          const Eigen::VectorXd V = coordinates_of(kind, x, cell);
          const std::size_t n     = V.size();
          Family volumetric(kind);
          volumetric.add(first_nodes(x.cols()),
                         {std::vector<double>(n, mu),
                          std::vector<double>(n, lambda),
                          std::vector<double>(V.begin(), V.end())});
          EXPECT_LT((forces_of(shear, x) + forces_of(volumetric, x)).norm(),
                    1e-13);
          // Its tangent there is that of linear elasticity.
          const Eigen::MatrixXd K =
            oracle::stiffness(x, cell, oracle::isotropic(dim, lambda, mu));
          EXPECT_LT(distance(Eigen::MatrixXd(tangent({shear, volumetric}, x)),
                             K),
                    1e-12);
        }
  }
} // namespace
