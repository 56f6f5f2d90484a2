// Spectra, steps that are seen to be stable, and the table of verdicts, against
// chains of springs, whose frequencies are known, and beams.

#include <springfit/comparison/bending_ratio.h>
#include <springfit/motion/critical_step.h>
#include <springfit/motion/observed_step.h>
#include <springfit/motion/step_systems.h>
#include <springfit/motion/stiffness_spectrum.h>
#include <springfit/output/stability_table.h>
#include <springfit/response/network_body.h>
#include <springfit/springs/rest_families.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cells.h"

using namespace springfit;

namespace
{
  /** n masses of 1 kg between two walls, springs of k N/m and 1 m; plane. */
  struct Chain
  {
    Chain(const unsigned int n, const double k)
      : n_free(n), k(k), nodes(places(n + 2)), network(nodes, springs(n + 2, k))
    {
      body.elastic = &network;
      body.mass    = Eigen::VectorXd::Ones(n + 2);
      body.held.assign(2 * (n + 2), false);
      for (unsigned int v = 0; v < n + 2; ++v)
        {
          body.held[2 * v + 1] = true; // it moves along itself only
          body.held[2 * v]     = v == 0 || v == n + 1;
        }
    }

    static Eigen::MatrixXd
    places(const unsigned int n)
    {
      Eigen::MatrixXd nodes = Eigen::MatrixXd::Zero(2, n);
      for (unsigned int v = 0; v < n; ++v)
        nodes(0, v) = v;
      return nodes;
    }

    static Families
    springs(const unsigned int n, const double k)
    {
      std::vector<NodePair> pairs;
      for (unsigned int v = 0; v + 1 < n; ++v)
        pairs.push_back({v, v + 1});
      return {lengths_at_rest(places(n),
                              pairs,
                              Eigen::VectorXd::Constant(n - 1, k),
                              SpringLaw::quadratic)};
    }

    /** Of the stiffness, and with masses of 1 of the square frequency. */
    double
    eigenvalue(const unsigned int mode) const
    {
      return 2. * k * (1. - std::cos(mode * M_PI / (n_free + 1)));
    }

    unsigned int n_free;
    double k;
    Eigen::MatrixXd nodes;
    NetworkBody network;
    MovingBody body;
  };
} // namespace


TEST(Spectrum, OfAChainIsKnown)
{
  // Of all eigenvalues, and of factors.
  for (const unsigned int n : {10u, 900u})
    {
      const Chain chain(n, 7.);
      const auto spectrum =
        stiffness_spectrum(chain.network, 0. * chain.nodes, chain.body.held);
      const double tolerance = n < 500 ? 1e-12 : 2e-3;
      EXPECT_NEAR(spectrum.largest / chain.eigenvalue(n), 1., tolerance);
      EXPECT_NEAR(spectrum.smallest / chain.eigenvalue(1), 1., tolerance);
      EXPECT_EQ(spectrum.n_negative, 0u);
      EXPECT_EQ(spectrum.n_mechanisms, 0u);
    }
}

TEST(Spectrum, CountsMechanismsAndMotionsThatReleaseEnergy)
{
  for (const unsigned int n : {10u, 900u})
    {
      Chain chain(n, 7.);
      auto held = chain.body.held;
      // A node that may go sideways costs nothing there.
      held[2 * 3 + 1] = false;
      held[2 * 6 + 1] = false;
      auto spectrum = stiffness_spectrum(chain.network, 0. * chain.nodes, held);
      EXPECT_EQ(spectrum.n_mechanisms, 2u);
      EXPECT_EQ(spectrum.n_negative, 0u);
      EXPECT_EQ(spectrum.smallest, 0.);

      // Under compression it does even better: the stiffness is the force by
      // the length of each spring.
      Eigen::MatrixXd displacement = -0.1 * chain.nodes;
      spectrum = stiffness_spectrum(chain.network, displacement, held);
      EXPECT_EQ(spectrum.n_negative, 2u);
      const double exact = -2. * 7. * 0.1 / 0.9;
      EXPECT_NEAR(spectrum.smallest, exact, 2e-3 * std::abs(exact));
    }
}

TEST(ObservedStep, IsThatOfTheFastestMotion)
{
  Chain chain(20, 50.);
  const auto system  = make_step_system(2, chain.body);
  const double exact = 2. / std::sqrt(chain.eigenvalue(20));
  const double observed =
    observed_step(chain.body, *system.system, 2, 1.3 * exact, 2000, 0.002, 21.);
  EXPECT_NEAR(observed / exact, 1., 0.01);
  EXPECT_NEAR(critical_step(chain.body, 0. * chain.nodes).step / exact,
              1.,
              0.002);
}

TEST(ObservedStep, FallsWithDampingAsItShould)
{
  for (const RayleighDamping damping :
       {RayleighDamping{2., 0.}, RayleighDamping{0., 0.02}})
    {
      Chain chain(20, 50.);
      chain.body.damping = damping;
      const auto system  = make_step_system(2, chain.body);
      const double exact =
        stable_step(damping, std::sqrt(chain.eigenvalue(20)));
      const double observed =
        observed_step(chain.body, *system.system, 2, exact, 4000, 0.002, 21.);
      EXPECT_NEAR(observed / exact, 1., 0.02);
    }
}

TEST(ObservedStep, DriftsNowhereBelow)
{
  Chain chain(20, 50.);
  const auto system  = make_step_system(2, chain.body);
  const double limit = 2. / std::sqrt(chain.eigenvalue(20));
  const auto slow =
    observe(chain.body, *system.system, 2, 0.1 * limit, 5000, 21.);
  EXPECT_FALSE(slow.grows);
  EXPECT_LT(std::abs(slow.energy_drift), 0.02);
  EXPECT_TRUE(
    observe(chain.body, *system.system, 2, 1.02 * limit, 2000, 21.).grows);
}


TEST(BendingRatio, OfRectanglesAndBricksIsKnown)
{
  // Of ratio L / h: 1 / (1 - nu^2) + (L / h)^2 / (2 (1 + nu)) in plane stress,
  // ((lambda + 2 mu) + mu (L / h)^2) / E in space.
  oracle::Random random(3);
  for (const double nu : {0., 0.3, 0.45})
    for (const double aspect : {1., 2., 5.})
      {
        Eigen::MatrixXd square = oracle::regular_cell(CellKind::quadrilateral);
        square.row(0) *= aspect;
        square = random.rotation(2) * square;
        const double plane =
          1. / (1. - nu * nu) + aspect * aspect / (2. * (1. + nu));
        EXPECT_NEAR(bending_ratio(square,
                                  CellKind::quadrilateral,
                                  oracle::stiffness(square,
                                                    CellKind::quadrilateral,
                                                    oracle::plane_stress(nu)),
                                  1.),
                    plane,
                    1e-10 * plane);

        Eigen::MatrixXd cube = oracle::regular_cell(CellKind::hexahedron);
        cube.row(0) *= aspect;
        cube                = random.rotation(3) * cube;
        const double mu     = 0.5 / (1. + nu);
        const double lambda = nu / ((1. + nu) * (1. - 2. * nu));
        const double solid  = lambda + 2. * mu + mu * aspect * aspect;
        EXPECT_NEAR(bending_ratio(cube,
                                  CellKind::hexahedron,
                                  oracle::stiffness(cube,
                                                    CellKind::hexahedron,
                                                    oracle::solid(nu)),
                                  1.),
                    solid,
                    1e-10 * solid);
      }
}


TEST(StabilityTable, ReadsBackWhatItWrites)
{
  StabilityRow row;
  row.axes          = {{"poissons_ratio", 0.45}, {"size_m", {}}};
  row.fit           = "frobenius";
  row.enrichment    = "volume";
  row.kinematics    = "nonlinear";
  row.integrator    = "-";
  row.calibration   = "certified";
  row.verdict       = "unstable";
  row.reason        = "2 motions, of many, release energy";
  row.n_unstable    = 2;
  row.condition     = 1.25e3;
  row.observed_step = 3.5e-4;
  CsvTable table(stability_header({"poissons_ratio", "size_m"}));
  table.new_row();
  add_row(row, table);
  std::string line = table.take_rows();
  line.pop_back();
  const auto read = parse_row(line, {"poissons_ratio", "size_m"});
  ASSERT_TRUE(read);
  EXPECT_EQ(key_of(*read), key_of(row));
  EXPECT_EQ(read->verdict, "unstable");
  EXPECT_EQ(read->reason, "2 motions; of many; release energy");
  EXPECT_EQ(read->n_unstable, 2u);
  EXPECT_EQ(read->condition, 1.25e3);
  EXPECT_EQ(read->observed_step, 3.5e-4);
  EXPECT_FALSE(read->e_rms);
  EXPECT_FALSE(read->axes[1].second);
  EXPECT_FALSE(parse_row(line.substr(0, 20), {"poissons_ratio", "size_m"}));
}
