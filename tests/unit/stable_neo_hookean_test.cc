// Springs under tension and volumes under pressure are the finite element: at
// rest, and at large deformation that of their law.

#include <springfit/fit/cell/finite_element_stiffness.h>
#include <springfit/fit/cell/stable_neo_hookean.h>
#include <springfit/fit/fit.h>
#include <springfit/springs/cell_quadrature.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rigid_modes.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  const std::vector<double> ratios = {-0.5, 0., 0.3, 0.45, 0.49};

  /** A cell of E = 1 and a thickness of 0.3 in the plane. */
  FitProblem
  problem_of(const Eigen::MatrixXd &points,
             const CellKind kind,
             const double nu,
             const bool is_plane_strain)
  {
    const int dim               = points.rows();
    const double h              = dim == 2 ? 0.3 : 1.;
    const double mu             = 0.5 / (1. + nu);
    const double lambda         = nu / ((1. + nu) * (1. - 2. * nu));
    const double lambda_here    = dim == 2 && !is_plane_strain
                                    ? 2. * lambda * mu / (lambda + 2. * mu)
                                    : lambda;
    auto material               = isotropic_material(dim, lambda_here, mu, h);
    material.is_in_plane_stress = dim == 2 && !is_plane_strain;
    return make_fit_problem(
      points,
      kind,
      h * oracle::stiffness(points,
                            kind,
                            oracle::isotropic(dim, lambda_here, mu)),
      material);
  }

  using Check = std::function<void(const FitProblem &, double nu)>;

  /** Calls @p check with random cells of every kind, ratio and plane state. */
  void
  for_each_problem(const Check &check)
  {
    Random random(37);
    for (const CellKind kind : oracle::all_kinds)
      for (const double nu : ratios)
        for (const bool is_plane_strain : {false, true})
          for (int n = 0; n < 5; ++n)
            {
              SCOPED_TRACE(word_of(cell_kind_words(), kind) + ", nu " +
                           std::to_string(nu));
              check(problem_of(oracle::random_cell(kind, random),
                               kind,
                               nu,
                               is_plane_strain),
                    nu);
            }
  }

  /** The forces that a cell at rest has, relative to those of its springs. */
  double
  leftover_at_rest(const CellModel &model, const Eigen::MatrixXd &x)
  {
    Eigen::MatrixXd all     = Eigen::MatrixXd::Zero(x.rows(), x.cols());
    Eigen::MatrixXd springs = all;
    add_forces(model.families, x, all);
    add_forces({model.families.front()}, x, springs);
    return all.norm() / springs.norm();
  }

  TEST(StableNeoHookean, PointsAreTheFiniteElementAtRest)
  {
    for_each_problem([](const FitProblem &problem, double) {
      for (const VolumeLaw law : {VolumeLaw::quadratic, VolumeLaw::logarithmic})
        {
          const auto model = fit_stable_neo_hookean_points(problem, law);
          EXPECT_LT(leftover_at_rest(model, problem.points), 1e-13);
          EXPECT_LT(residual(problem, model).norm(),
                    1e-13 * problem.stiffness.norm());
        }
    });
  }

  TEST(FiniteElementStiffness, AgreesWithIndependentIntegration)
  {
    for_each_problem([](const FitProblem &problem, double) {
      const auto R = finite_element_stiffness(problem.points,
                                              problem.kind,
                                              problem.material);
      EXPECT_LT((R - problem.stiffness).norm(),
                1e-13 * problem.stiffness.norm());
    });
  }

  TEST(StableNeoHookean, OneVolumeIsRightOnConstantStrains)
  {
    for_each_problem([](const FitProblem &problem, double) {
      for (const VolumeLaw law : {VolumeLaw::quadratic, VolumeLaw::logarithmic})
        {
          const auto model = fit_stable_neo_hookean_volume(problem, law);
          EXPECT_LT(leftover_at_rest(model, problem.points), 1e-13);
          const Eigen::MatrixXd E = residual(problem, model);
          EXPECT_LT((E * affine_basis(problem.points)).norm(),
                    1e-13 * problem.stiffness.norm());
        }
    });
  }

  TEST(StableNeoHookean, OneVolumeIsPositiveOnEveryDeformation)
  {
    for_each_problem([](const FitProblem &problem, double) {
      const auto result = fit(problem,
                              method_named("stable neo-hookean"),
                              {Enrichment::volume, /*nonnegative*/ true});
      EXPECT_GT(*result.smallest_eigenvalue, 1e-4);
    });
  }

  /**
   * A cube's hourglass modes: 17, 5, 1 and 0.2 % of the largest eigenvalue at
   * nu = 0, 0.3, 0.45 and 0.49.
   */
  TEST(StableNeoHookean, OneVolumeOfACubeSoftensItsHourglassModes)
  {
    const std::vector<std::pair<double, double>> checked = {{0., 0.17},
                                                            {0.3, 0.05},
                                                            {0.45, 0.01},
                                                            {0.49, 0.002}};
    for (const auto &[nu, eigenvalue] : checked)
      {
        const auto problem =
          problem_of(oracle::regular_cell(CellKind::hexahedron),
                     CellKind::hexahedron,
                     nu,
                     false);
        const auto result = fit(problem,
                                method_named("stable neo-hookean"),
                                {Enrichment::volume});
        EXPECT_NEAR(*result.smallest_eigenvalue / eigenvalue, 1., 0.35);
      }
  }

  // The energy of a law at a deformation gradient, per volume at rest.

  double
  stable_neo_hookean(const Eigen::MatrixXd &F,
                     const double lambda,
                     const double mu)
  {
    const double J = F.determinant();
    return 0.5 * mu * (F.squaredNorm() - F.rows()) - mu * (J - 1.) +
           0.5 * (lambda + mu) * (J - 1.) * (J - 1.);
  }

  double
  neo_hookean(const Eigen::MatrixXd &F, const double lambda, const double mu)
  {
    const double log_J = std::log(F.determinant());
    return 0.5 * mu * (F.squaredNorm() - F.rows()) - mu * log_J +
           0.5 * lambda * log_J * log_J;
  }

  /** The same with the thickness stretch that makes it smallest. */
  double
  neo_hookean_plane_stress(const Eigen::MatrixXd &F,
                           const double lambda, // of plane stress
                           const double mu)
  {
    const double lambda_3 = 2. * mu * lambda / (2. * mu - lambda);
    const auto energy     = [&](const double stretch) {
      Eigen::MatrixXd F_3     = Eigen::MatrixXd::Identity(3, 3);
      F_3.topLeftCorner(2, 2) = F;
      F_3(2, 2)               = stretch;
      return neo_hookean(F_3, lambda_3, mu);
    };
    double low = 0.1, high = 10.; // golden section
    const double ratio = 0.5 * (std::sqrt(5.) - 1.);
    while (high - low > 1e-9)
      {
        const double a                       = high - ratio * (high - low);
        const double b                       = low + ratio * (high - low);
        (energy(a) < energy(b) ? high : low) = energy(a) < energy(b) ? b : a;
      }
    return energy(0.5 * (low + high));
  }

  /** The integral of the law over a deformed cell. */
  double
  integrated(const FitProblem &problem,
             const Eigen::MatrixXd &x,
             const VolumeLaw law)
  {
    const auto &material = problem.material;
    const double mu      = shear_modulus(material);
    const double lambda  = first_lame_constant(x.rows(), material);
    double sum           = 0.;
    for (const auto &[gradients, weight] : cell_quadrature(problem.kind))
      {
        const Eigen::MatrixXd J = problem.points * gradients.transpose();
        const Eigen::MatrixXd F = x * gradients.transpose() * J.inverse();
        const double density    = law == VolumeLaw::quadratic
                                    ? stable_neo_hookean(F, lambda, mu)
                                  : material.is_in_plane_stress
                                    ? neo_hookean_plane_stress(F, lambda, mu)
                                    : neo_hookean(F, lambda, mu);
        sum += material.thickness * weight * J.determinant() * density;
      }
    return sum;
  }

  TEST(StableNeoHookean, EnergyAtLargeDeformationsIsThatOfTheLaw)
  {
    Random random(5);
    for_each_problem([&](const FitProblem &problem, const double nu) {
      const auto &X           = problem.points;
      const Eigen::MatrixXd x = X + 0.15 * random.matrix(X.rows(), X.cols());
      for (const VolumeLaw law : {VolumeLaw::quadratic, VolumeLaw::logarithmic})
        {
          if (law == VolumeLaw::logarithmic && nu < 0.)
            continue; // no thickness may leave the plane without stress
          const auto model = fit_stable_neo_hookean_points(problem, law);
          const double found =
            energy(model.families, x) - energy(model.families, X);
          if (!std::isfinite(found))
            continue; // turned inside out
          const double expected =
            integrated(problem, x, law) - integrated(problem, X, law);
          EXPECT_NEAR(found, expected, 1e-10 * (1. + std::abs(expected)));
        }
    });
  }

  TEST(StableNeoHookean, SpringsOppositeToObtuseAnglesAreNegative)
  {
    Eigen::MatrixXd obtuse(2, 3);
    obtuse << 0., 1., -0.5, //
      0., 0., 0.5;
    const auto problem = problem_of(obtuse, CellKind::triangle, 0.3, false);
    const Eigen::VectorXd k =
      fit_stable_neo_hookean_volume(problem, VolumeLaw::quadratic).k();
    EXPECT_GT(k[0], 0.);
    EXPECT_GT(k[1], 0.);
    EXPECT_LT(k[2], 0.); // from vertex 1 to 2, opposite to the angle at 0
  }
} // namespace
