#include <springfit/reference/material_law.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "nonlinear.h"

using namespace springfit;
using namespace springfit::oracle;

TEST(MaterialLaws, StressAndTangentAreDerivativesOfTheEnergy)
{
  Random random(21);
  const auto lame         = solid_material(2., 0.3).lame;
  const auto sheet        = sheet_material(2., 0.3).lame;
  const auto voigt_vector = [](const auto &tensor, const double shear) {
    // 11 22 (33) 12 23 31; the shears of strains are doubled.
    constexpr int dim     = std::decay_t<decltype(tensor)>::RowsAtCompileTime;
    constexpr int n_voigt = dim * (dim + 1) / 2;
    Eigen::Matrix<double, n_voigt, 1> voigt;
    for (int d = 0; d < dim; ++d)
      voigt[d] = tensor(d, d);
    for (int s = 0; s < n_voigt - dim; ++s)
      voigt[dim + s] = shear * tensor(s, (s + 1) % dim);
    return voigt;
  };
  const auto check = [&](const auto &law, const auto &F0) {
    using Tensor            = std::decay_t<decltype(F0)>;
    constexpr int dim       = Tensor::RowsAtCompileTime;
    const Tensor dF         = random_matrix(dim, dim, 1., random);
    const double h          = 1e-5;
    const auto state        = law(F0);
    const Tensor Fp         = F0 + h * dF;
    const Tensor Fm         = F0 - h * dF;
    const auto plus         = law(Fp);
    const auto minus        = law(Fm);
    const double expected   = (F0 * state.stress).cwiseProduct(dF).sum();
    const double difference = (plus.energy - minus.energy) / (2. * h);
    EXPECT_NEAR(difference, expected, 1e-8);
    const Tensor dE = (Fp.transpose() * Fp - Fm.transpose() * Fm) / (4. * h);
    const Tensor dS = (plus.stress - minus.stress) / (2. * h);
    EXPECT_LT(
      (voigt_vector(dS, 1.) - state.tangent * voigt_vector(dE, 2.)).norm(),
      1e-8);
  };
  for (unsigned int sample = 0; sample < 10; ++sample)
    {
      const Eigen::Matrix2d F2 =
        Eigen::Matrix2d::Identity() + random_matrix(2, 2, 0.3, random);
      const Eigen::Matrix3d F3 =
        Eigen::Matrix3d::Identity() + random_matrix(3, 3, 0.2, random);
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
