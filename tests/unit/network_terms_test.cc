// What a network has besides springs: volumes and couplings of lengths.

#include <springfit/springs/coupling.h>
#include <springfit/springs/generalised_spring.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/network.h>

#include <gtest/gtest.h>

#include <stdexcept>

#include "cells.h"
#include "derivative.h"

using namespace springfit;
using springfit::oracle::derivative;
using springfit::oracle::Random;
using springfit::oracle::scalar;

namespace
{
  /** The spring ends of a coupling as points: i_a, j_a, i_b, j_b. */
  template <int dim>
  void
  check_coupling()
  {
    Random random(24);
    const double stiffness = 3., L_a = 0.7, L_b = 1.6;
    const Eigen::MatrixXd x = random.matrix(dim, 4);
    using d_type            = Vector<dim>;
    const auto apply        = [&](const auto &f, const Eigen::MatrixXd &y) {
      return f(stiffness,
               L_a,
               L_b,
               d_type(y.col(1) - y.col(0)),
               d_type(y.col(3) - y.col(2)));
    };
    const auto energy = [&](const Eigen::MatrixXd &y) {
      return scalar(apply(coupling_energy<dim>, y));
    };
    const auto gradient = [&](const Eigen::MatrixXd &y) {
      return Eigen::VectorXd(apply(coupling_gradient<dim>, y));
    };
    const Eigen::MatrixXd H = apply(coupling_hessian<dim>, x);

    EXPECT_NEAR(energy(x)[0],
                stiffness * ((x.col(1) - x.col(0)).norm() - L_a) *
                  ((x.col(3) - x.col(2)).norm() - L_b),
                1e-14);
    EXPECT_LT((derivative(energy, x).transpose() - gradient(x)).norm(), 1e-8);
    EXPECT_LT((derivative(gradient, x) - H).norm(), 1e-8);

    const Eigen::MatrixXd Q = random.rotation(dim);
    EXPECT_NEAR(energy(Q * x)[0], energy(x)[0], 1e-14);
    EXPECT_LT(
      (Eigen::Map<const Eigen::MatrixXd>(gradient(Q * x).eval().data(),
                                         dim,
                                         4) -
       Q * Eigen::Map<const Eigen::MatrixXd>(gradient(x).eval().data(), dim, 4))
        .norm(),
      1e-13);
  }

  TEST(Coupling, DerivativesAgreeWithDifferencesAndTurnWithTheNodes)
  {
    check_coupling<2>();
    check_coupling<3>();
  }


  class TwoTriangles : public ::testing::Test
  {
  protected:
    //  2 - 3
    //  | \ |
    //  0 - 1      springs: 01, 02, 12, 13, 23
    TwoTriangles() : builder(nodes())
    {
      builder.add_springs(lower, pairs, Eigen::Vector3d(1., 2., 3.));
      builder.add_springs(upper, pairs, Eigen::Vector3d(1., 2., 3.));
    }

    static Eigen::MatrixXd
    nodes()
    {
      Eigen::MatrixXd x(2, 4);
      x << 0., 2., 0., 2., //
        0., 0., 1., 1.;
      return x;
    }

    const std::vector<NodePair> &pairs    = node_pairs(CellKind::triangle);
    const std::vector<unsigned int> lower = {0, 1, 2};
    const std::vector<unsigned int> upper = {3, 2, 1};
    NetworkBuilder builder;
  };

  TEST_F(TwoTriangles, CouplingsNameTheSpringsOfTheNetwork)
  {
    // Of (01, 02, 12), and of (32, 31, 21): the last one is shared.
    builder.add_couplings(lower, pairs, {{0, 1, 10.}, {0, 2, 20.}});
    builder.add_couplings(upper, pairs, {{1, 2, 40.}, {0, 2, 30.}});
    const auto couplings = builder.build().couplings;
    std::vector<std::vector<double>> found;
    for (const auto &[a, b, stiffness] : couplings)
      found.push_back({double(a), double(b), stiffness});
    EXPECT_EQ(found,
              (std::vector<std::vector<double>>{
                {0, 1, 10.}, {0, 2, 20.}, {2, 3, 40.}, {2, 4, 30.}}));
  }

  TEST_F(TwoTriangles, CouplingsOfTheSameSpringsAreAdded)
  {
    builder.add_couplings(lower, pairs, {{1, 2, 10.}});
    builder.add_couplings({2, 1, 0}, pairs, {{0, 1, 5.}}); // 21 and 20
    const auto couplings = builder.build().couplings;
    ASSERT_EQ(couplings.size(), 1u);
    EXPECT_EQ(couplings[0].a, 1u);
    EXPECT_EQ(couplings[0].b, 2u);
    EXPECT_EQ(couplings[0].stiffness, 15.);
  }

  TEST_F(TwoTriangles, ACouplingNeedsItsSprings)
  {
    builder.add_couplings({0, 1, 3}, pairs, {{0, 1, 10.}}); // no spring 03
    EXPECT_THROW(builder.build(), std::logic_error);
  }

  TEST_F(TwoTriangles, VolumesKeepTheirNodes)
  {
    builder.add_volume(lower, 7., 1.);
    builder.add_volume(upper, 8., 1.);
    const auto volumes = builder.build().volumes;
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_EQ(volumes[1].nodes, upper);
    EXPECT_EQ(volumes[1].stiffness, 8.);
    EXPECT_EQ(volumes[1].rest_volume, 1.);
  }
} // namespace
