// The network that is assembled from cells.

#include <springfit/springs/cell_topology.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/network.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  class TwoTriangles : public ::testing::Test
  {
  protected:
    //  2 - 3
    //  | \ |
    //  0 - 1      springs: 01, 02, 12, 13, 23
    TwoTriangles() : builder(nodes())
    {
      builder.add_springs(lower, pairs, Eigen::Vector3d(1., 2., 3.));
      // The shared spring comes as (2, 1) here.
      builder.add_springs(upper, pairs, Eigen::Vector3d(10., 20., -30.));
      builder.add_masses(lower, Eigen::Vector3d(0.1, 0.2, 0.3));
      builder.add_masses(upper, Eigen::Vector3d(1., 2., 3.));
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

  TEST_F(TwoTriangles, SpringsAreSortedAndMerged)
  {
    using Nodes        = std::vector<unsigned int>;
    const auto network = builder.build();
    EXPECT_EQ(network.i, (Nodes{0, 0, 1, 1, 2}));
    EXPECT_EQ(network.j, (Nodes{1, 2, 2, 3, 3}));
    EXPECT_EQ(network.stiffness, (std::vector<double>{1., 2., -27., 20., 10.}));
    EXPECT_EQ(n_negative(network), 1u);
  }

  TEST_F(TwoTriangles, RestLengthsAreTheDistances)
  {
    EXPECT_EQ(builder.build().rest_length,
              (std::vector<double>{2., 1., std::sqrt(5.), 1., 2.}));
  }

  TEST_F(TwoTriangles, MassesAreAdded)
  {
    EXPECT_EQ(builder.build().mass, (std::vector<double>{0.1, 3.2, 2.3, 1.}));
  }

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

  TEST_F(TwoTriangles, AnglesOfTheSameNodesAreAdded)
  {
    // Those at 0, 1, 2 of the lower triangle, at 3 of the upper one, and one of
    // the lower triangle again with its ends exchanged.
    const auto &triples = cell_angles(CellKind::triangle);
    builder.add_angles(lower, triples, Eigen::Vector3d(1., 2., 3.));
    builder.add_angles(upper, {triples[0]}, Eigen::VectorXd::Constant(1, 4.));
    builder.add_angles({2, 1, 0},
                       {{2, 1, 0}},
                       Eigen::VectorXd::Constant(1, 9.));
    const auto angles = builder.build().angles;
    std::vector<NodeTriple> found;
    std::vector<double> stiffness;
    for (const auto &spring : angles)
      {
        found.push_back(spring.nodes);
        stiffness.push_back(spring.stiffness);
      }
    EXPECT_EQ(
      found,
      (std::vector<NodeTriple>{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 3, 2}}));
    EXPECT_EQ(stiffness, (std::vector<double>{11., 3., 1., 4.}));
    // The legs are 2 and 1.
    EXPECT_NEAR(angles[0].rest_angle, std::atan(0.5), 1e-15);
    EXPECT_NEAR(angles[1].rest_angle, std::atan(2.), 1e-15);
    EXPECT_NEAR(angles[2].rest_angle, std::acos(0.), 1e-15);
  }

  TEST_F(TwoTriangles, ADegenerateAngleIsNoPartOfANetwork)
  {
    EXPECT_THROW(builder.add_angles({0, 1, 1},
                                    {{0, 1, 2}},
                                    Eigen::VectorXd::Ones(1)),
                 std::logic_error);
  }

  TEST_F(TwoTriangles, HaveSpringsAloneUntilSomethingIsAdded)
  {
    EXPECT_TRUE(has_springs_alone(builder.build()));
    builder.add_angles(lower, {{0, 1, 2}}, Eigen::VectorXd::Ones(1));
    EXPECT_FALSE(has_springs_alone(builder.build()));
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

  TEST(Network, TangentIsTheSumOfTheCells)
  {
    // Two hexahedra with a common face: nodes 0 .. 11, face 4 .. 7.
    Random random(6);
    Eigen::MatrixXd nodes(3, 12);
    for (int v = 0; v < 12; ++v)
      nodes.col(v) << (v & 1), (v >> 1 & 1), (v >> 2);
    nodes += 0.1 * random.matrix(3, 12);
    const std::vector<std::vector<unsigned int>> cells = {
      {0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}};

    const auto &pairs = node_pairs(CellKind::hexahedron);
    NetworkBuilder builder(nodes);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(36, 36);
    for (const auto &cell : cells)
      {
        const Eigen::VectorXd k = random.matrix(28, 1);
        builder.add_springs(cell, pairs, k);
        Eigen::MatrixXd x(3, 8);
        for (int v = 0; v < 8; ++v)
          x.col(v) = nodes.col(cell[v]);
        const Eigen::MatrixXd B = length_gradients(x, pairs);
        K.block<24, 24>(3 * cell[0], 3 * cell[0]) +=
          B * k.asDiagonal() * B.transpose();
      }

    const SpringNetwork network = builder.build();
    std::vector<NodePair> springs;
    for (std::size_t s = 0; s < network.i.size(); ++s)
      springs.push_back({{network.i[s], network.j[s]}});
    EXPECT_EQ(springs.size(), 28u + 28u - 6u);
    const Eigen::MatrixXd B = length_gradients(nodes, springs);
    const Eigen::Map<const Eigen::VectorXd> k(network.stiffness.data(),
                                              network.stiffness.size());
    EXPECT_LT((K - B * k.asDiagonal() * B.transpose()).norm(), 1e-13);
  }
} // namespace
