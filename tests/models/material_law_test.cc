#include <springfit/reference/material_law.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "nonlinear.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  /** P and dP/dF of a law at F0 against central differences along any dF. */
  template <int dim, typename Law>
  void
  check_material_derivatives(const Law &law,
                             const Eigen::Matrix<double, dim, dim> &F0,
                             Random &random)
  {
    using Tensor            = Eigen::Matrix<double, dim, dim>;
    const Tensor dF         = random_matrix(dim, dim, 1., random);
    const double h          = 1e-5;
    const auto state        = law(F0);
    const Tensor Fp         = F0 + h * dF;
    const Tensor Fm         = F0 - h * dF;
    const auto plus         = law(Fp);
    const auto minus        = law(Fm);
    const double difference = (plus.energy - minus.energy) / (2. * h);
    EXPECT_NEAR(difference, state.stress.cwiseProduct(dF).sum(), 1e-8);
    const Tensor dP = (plus.stress - minus.stress) / (2. * h);
    EXPECT_LT((dP.reshaped() - state.tangent * dF.reshaped()).norm(), 1e-8);
    EXPECT_LT((state.tangent - state.tangent.transpose()).norm(),
              1e-13 * state.tangent.norm());
  }

  /** A random F with the given determinant. */
  template <int dim>
  Eigen::Matrix<double, dim, dim>
  deformation_gradient(const double J, Random &random)
  {
    using Tensor = Eigen::Matrix<double, dim, dim>;
    Tensor F     = random_matrix(dim, dim, 1., random);
    while (std::abs(F.determinant()) < 0.3)
      F = random_matrix(dim, dim, 1., random);
    if (J == 0.)
      F.col(0) = F.rightCols(dim - 1) *
                 random_matrix(dim - 1, 1, 1., random); // of rank dim - 1
    else
      {
        F *= std::pow(std::abs(J / F.determinant()), 1. / dim);
        if (J * F.determinant() < 0.)
          F.col(0) *= -1.;
      }
    return F;
  }
} // namespace

TEST(MaterialLaws, StressAndTangentAreDerivativesOfTheEnergy)
{
  Random random(21);
  const auto lame  = solid_material(2., 0.3).lame;
  const auto sheet = sheet_material(2., 0.3).lame;
  for (unsigned int sample = 0; sample < 10; ++sample)
    {
      const Eigen::Matrix2d F2 =
        Eigen::Matrix2d::Identity() + random_matrix(2, 2, 0.3, random);
      const Eigen::Matrix3d F3 =
        Eigen::Matrix3d::Identity() + random_matrix(3, 3, 0.2, random);
      const auto check = [&](const auto &law, const auto &F) {
        constexpr int dim = std::decay_t<decltype(F)>::RowsAtCompileTime;
        check_material_derivatives<dim>(law, F, random);
      };
      check([&](const auto &F) { return st_venant_kirchhoff<2>(F, lame); }, F2);
      check([&](const auto &F) { return st_venant_kirchhoff<3>(F, lame); }, F3);
      check([&](const auto &F) { return *neo_hookean<2>(F, lame); }, F2);
      check([&](const auto &F) { return *neo_hookean<3>(F, lame); }, F3);
      check([&](const auto &F) { return *neo_hookean_plane_stress(F, sheet); },
            F2);
    }
  EXPECT_FALSE(neo_hookean<2>(Eigen::Vector2d(1., -1.).asDiagonal(), lame));
  EXPECT_FALSE(
    neo_hookean_plane_stress(Eigen::Vector2d(1., -1.).asDiagonal(), sheet));
}

namespace
{
  template <int dim>
  void
  check_stable_neo_hookean()
  {
    using Tensor = Eigen::Matrix<double, dim, dim>;
    Random random(25);
    const LameConstants lame = usual_material<dim>(2., 0.3).lame;
    const double bulk        = lame.lambda + lame.mu;
    const double alpha       = 1. + lame.mu / bulk;
    const Tensor Q           = rotation<dim>();
    const auto law           = [&](const Tensor &F) {
      return stable_neo_hookean<dim>(F, lame);
    };

    for (const double J : {2., 1., 0.3, 0., -0.3, -1., -2.})
      for (unsigned int sample = 0; sample < 10; ++sample)
        {
          const Tensor F = deformation_gradient<dim>(J, random);
          EXPECT_NEAR(F.determinant(), J, 1e-14);
          check_material_derivatives<dim>(law, F, random);

          // The energy as the paper writes it, up to a constant.
          const double constant =
            law(Tensor::Identity()).energy -
            (0.5 * lame.mu * dim + 0.5 * bulk * (1. - alpha) * (1. - alpha));
          EXPECT_NEAR(law(F).energy,
                      0.5 * lame.mu * F.squaredNorm() +
                        0.5 * bulk * (J - alpha) * (J - alpha) + constant,
                      1e-12);

          // A rotation of the deformed material turns the stress with it.
          const auto turned = law(Q * F);
          EXPECT_NEAR(turned.energy, law(F).energy, 1e-12);
          EXPECT_LT((turned.stress - Q * law(F).stress).norm(), 1e-12);
        }

    // All of the material in a point, in a plane, and mirrored: exact.
    for (const double a : {0., -1., 0.5, 1.7})
      {
        const auto state = law(a * Tensor::Identity());
        const double J   = std::pow(a, dim);
        EXPECT_NEAR(state.energy,
                    0.5 * dim * lame.mu * (a * a - 1.) - lame.mu * (J - 1.) +
                      0.5 * bulk * (J - 1.) * (J - 1.),
                    1e-14);
        const double stress =
          lame.mu * a + (bulk * (J - 1.) - lame.mu) * std::pow(a, dim - 1);
        EXPECT_LT((state.stress - stress * Tensor::Identity()).norm(), 1e-14);
      }
    Tensor flat        = Tensor::Identity();
    flat(0, 0)         = 0.;
    Tensor stress      = lame.mu * flat;
    stress(0, 0)       = -(bulk + lame.mu);
    const auto pressed = law(flat);
    EXPECT_LT((pressed.stress - stress).norm(), 1e-14);
    EXPECT_TRUE(pressed.tangent.allFinite());
    EXPECT_NEAR(pressed.energy, 0.5 * (lame.mu + bulk), 1e-14);
  }

  /** lambda I (x) I + 2 mu I_sym: linear elasticity. */
  template <int dim>
  Eigen::MatrixXd
  linear_tangent(const LameConstants &lame)
  {
    Eigen::MatrixXd tangent(dim * dim, dim * dim);
    for (int i = 0; i < dim; ++i)
      for (int k = 0; k < dim; ++k)
        for (int j = 0; j < dim; ++j)
          for (int l = 0; l < dim; ++l)
            tangent(i + dim * k, j + dim * l) =
              lame.lambda * (i == k) * (j == l) +
              lame.mu * ((i == j) * (k == l) + (i == l) * (k == j));
    return tangent;
  }

  template <int dim>
  void
  check_rest(const MaterialState<dim> &state, const LameConstants &lame)
  {
    EXPECT_NEAR(state.energy, 0., 1e-15);
    EXPECT_LT(state.stress.norm(), 1e-15);
    EXPECT_LT((state.tangent - linear_tangent<dim>(lame)).norm(), 1e-14);
  }
} // namespace

TEST(MaterialLaws, AllAreLinearElasticityAtRest)
{
  const auto I2 = Eigen::Matrix2d::Identity();
  const auto I3 = Eigen::Matrix3d::Identity();
  for (const double nu : {-0.5, 0., 0.3, 0.45})
    {
      const auto lame  = solid_material(2., nu).lame;
      const auto sheet = sheet_material(2., nu).lame;
      EXPECT_NEAR(sheet.lambda,
                  2. * lame.lambda * lame.mu / (lame.lambda + 2. * lame.mu),
                  1e-14);
      check_rest<3>(st_venant_kirchhoff<3>(I3, lame), lame);
      check_rest<3>(*neo_hookean<3>(I3, lame), lame);
      check_rest<3>(stable_neo_hookean<3>(I3, lame), lame);
      check_rest<2>(st_venant_kirchhoff<2>(I2, lame), lame);
      check_rest<2>(*neo_hookean<2>(I2, lame), lame);
      check_rest<2>(stable_neo_hookean<2>(I2, lame), lame);
      check_rest<2>(st_venant_kirchhoff<2>(I2, sheet), sheet);
      check_rest<2>(*neo_hookean_plane_stress(I2, sheet), sheet);
      check_rest<2>(stable_neo_hookean<2>(I2, sheet), sheet);
    }
}

TEST(MaterialLaws, StableNeoHookeanGoesThroughInversion)
{
  check_stable_neo_hookean<2>();
  check_stable_neo_hookean<3>();
}

TEST(MaterialLaws, PlaneStressIsThreeDimensionalWithoutStressAcross)
{
  for (const double nu : {0., 0.3, 0.49})
    {
      Eigen::Matrix2d F;
      F << 1.3, 0.2, -0.1, 0.9;
      const auto sheet =
        neo_hookean_plane_stress(F, sheet_material(2., nu).lame);
      // Bisection for the stretch across the plane.
      double low = 0.1, high = 3.;
      Eigen::Matrix3d F3     = Eigen::Matrix3d::Identity();
      F3.topLeftCorner(2, 2) = F;
      for (unsigned int step = 0; step < 60; ++step)
        {
          F3(2, 2)  = 0.5 * (low + high);
          (neo_hookean<3>(F3, solid_material(2., nu).lame)->stress(2, 2) > 0.
             ? high
             : low) = F3(2, 2);
        }
      const auto solid = neo_hookean<3>(F3, solid_material(2., nu).lame);
      EXPECT_LT((solid->stress.topLeftCorner(2, 2) - sheet->stress).norm(),
                1e-12);
      EXPECT_NEAR(solid->energy, sheet->energy, 1e-12);
    }
  // The limit nu = 0.5 keeps the volume.
  const Eigen::Matrix2d F = Eigen::Vector2d(1.5, 0.8).asDiagonal();
  const auto state = neo_hookean_plane_stress(F, sheet_material(3., 0.5).lame);
  EXPECT_NEAR(state->energy,
              0.5 * (1.5 * 1.5 + 0.64 + 1. / (1.44) - 3.),
              1e-12);
}
