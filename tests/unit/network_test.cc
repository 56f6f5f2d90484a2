// The network that is assembled from cells.

#include <springfit/springs/cell_topology.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/network.h>
#include <springfit/springs/rest_families.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
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
      builder.add(springs(lower, Eigen::Vector3d(1., 2., 3.)), lower);
      // The shared spring comes as (2, 1) here.
      builder.add(springs(upper, Eigen::Vector3d(10., 20., -30.)), upper);
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

    static Eigen::MatrixXd
    points(const std::vector<unsigned int> &cell)
    {
      return nodes()(Eigen::all, cell);
    }

    Family
    springs(const std::vector<unsigned int> &cell,
            const Eigen::VectorXd &k) const
    {
      return lengths_at_rest(points(cell), pairs, k, SpringLaw::quadratic);
    }

    Family
    couplings(const std::vector<unsigned int> &cell,
              const std::vector<LengthCoupling> &all) const
    {
      return couplings_at_rest(points(cell), pairs, all, SpringLaw::quadratic);
    }

    /** Nodes and stiffness of each member of a family of the network. */
    using Found = std::vector<std::pair<std::vector<unsigned int>, double>>;

    Found
    found(const std::string &word) const
    {
      Found members;
      for (const auto &family : builder.build().families)
        if (family.kind->word() == word)
          for (std::size_t m = 0; m < family.size(); ++m)
            members.emplace_back(std::vector<unsigned int>(
                                   family.nodes(m),
                                   family.nodes(m) + family.kind->n_nodes()),
                                 family.members.columns[0][m]);
      return members;
    }

    /** A column of the only family of a word. */
    std::vector<double>
    column(const std::string &word, const unsigned int c) const
    {
      for (const auto &family : builder.build().families)
        if (family.kind->word() == word)
          return family.members.columns[c];
      return {};
    }

    const std::vector<NodePair> &pairs    = node_pairs(CellKind::triangle);
    const std::vector<unsigned int> lower = {0, 1, 2};
    const std::vector<unsigned int> upper = {3, 2, 1};
    NetworkBuilder builder;
  };

  TEST_F(TwoTriangles, SpringsAreSortedAndMerged)
  {
    EXPECT_EQ(found("springs"),
              (Found{{{0, 1}, 1.},
                     {{0, 2}, 2.},
                     {{1, 2}, -27.},
                     {{1, 3}, 20.},
                     {{2, 3}, 10.}}));
    const Families families = builder.build().families;
    EXPECT_EQ(n_negative(families), 1u);
    EXPECT_EQ(n_springs(families), 5u);
    Eigen::VectorXd k(5);
    k << 1., 2., -27., 20., 10.;
    EXPECT_EQ(spring_stiffness(families), k);
  }

  TEST_F(TwoTriangles, RestLengthsAreTheDistances)
  {
    EXPECT_EQ(column("springs", 1),
              (std::vector<double>{2., 1., std::sqrt(5.), 1., 2.}));
  }

  TEST_F(TwoTriangles, MassesAreAdded)
  {
    EXPECT_EQ(builder.build().mass, (std::vector<double>{0.1, 3.2, 2.3, 1.}));
  }

  TEST_F(TwoTriangles, CouplingsNameTheNodesOfTheirSprings)
  {
    // Of (01, 02, 12), and of (32, 31, 21): the last one is shared.
    builder.add(couplings(lower, {{0, 1, 10.}, {0, 2, 20.}}), lower);
    builder.add(couplings(upper, {{1, 2, 40.}, {0, 2, 30.}}), upper);
    EXPECT_EQ(found("couplings"),
              (Found{{{0, 1, 0, 2}, 10.},
                     {{0, 1, 1, 2}, 20.},
                     {{1, 2, 1, 3}, 40.},
                     {{1, 2, 2, 3}, 30.}}));
    EXPECT_EQ(column("couplings", 1),
              (std::vector<double>{2., 2., std::sqrt(5.), std::sqrt(5.)}));
    EXPECT_EQ(column("couplings", 2),
              (std::vector<double>{1., std::sqrt(5.), 1., 2.}));
  }

  TEST_F(TwoTriangles, CouplingsOfTheSameSpringsAreAdded)
  {
    builder.add(couplings(lower, {{1, 2, 10.}}), lower);
    // 21 and 20
    builder.add(couplings({2, 1, 0}, {{0, 1, 5.}}), {2, 1, 0});
    EXPECT_EQ(found("couplings"), (Found{{{0, 2, 1, 2}, 15.}}));
    EXPECT_EQ(column("couplings", 1), (std::vector<double>{1.}));
    EXPECT_EQ(column("couplings", 2), (std::vector<double>{std::sqrt(5.)}));
  }

  TEST_F(TwoTriangles, ACouplingNeedsNoSprings)
  {
    const std::vector<unsigned int> cell = {0, 1, 3}; // there is no spring 03
    builder.add(couplings(cell, {{0, 1, 10.}}), cell);
    EXPECT_EQ(found("couplings"), (Found{{{0, 1, 0, 3}, 10.}}));
    EXPECT_EQ(found("springs").size(), 5u);
    // Stretched along x by 1.5: 01 and 03 get longer.
    Eigen::MatrixXd x = nodes();
    x.row(0) *= 1.5;
    double of_springs = 0.;
    for (const auto &[pair, k] : found("springs"))
      {
        const double change =
          (x.col(pair[1]) - x.col(pair[0])).norm() -
          (nodes().col(pair[1]) - nodes().col(pair[0])).norm();
        of_springs += 0.5 * k * change * change;
      }
    EXPECT_NEAR(energy(builder.build().families, x),
                of_springs + 10. * (3. - 2.) * (std::sqrt(10.) - std::sqrt(5.)),
                1e-14 * 10.);
  }

  TEST_F(TwoTriangles, AnglesOfTheSameNodesAreAdded)
  {
    // Those at 0, 1, 2 of the lower triangle, at 3 of the upper one, and one of
    // the lower triangle again with its ends exchanged.
    const auto &triples = cell_angles(CellKind::triangle);
    builder.add(angles_at_rest(points(lower),
                               triples,
                               Eigen::Vector3d(1., 2., 3.)),
                lower);
    builder.add(angles_at_rest(points(upper),
                               {triples[0]},
                               Eigen::VectorXd::Constant(1, 4.)),
                upper);
    builder.add(angles_at_rest(points({2, 1, 0}),
                               {{2, 1, 0}},
                               Eigen::VectorXd::Constant(1, 9.)),
                {2, 1, 0});
    EXPECT_EQ(found("angles"),
              (Found{{{0, 1, 2}, 11.},
                     {{0, 2, 1}, 3.},
                     {{1, 0, 2}, 1.},
                     {{1, 3, 2}, 4.}}));
    // The legs are 2 and 1.
    const auto rest_angles = column("angles", 1);
    EXPECT_NEAR(rest_angles[0], std::atan(0.5), 1e-15);
    EXPECT_NEAR(rest_angles[1], std::atan(2.), 1e-15);
    EXPECT_NEAR(rest_angles[2], std::acos(0.), 1e-15);
  }

  TEST_F(TwoTriangles, ADegenerateAngleIsNoPartOfANetwork)
  {
    EXPECT_THROW(angles_at_rest(points({0, 1, 1}),
                                {{0, 1, 2}},
                                Eigen::VectorXd::Ones(1)),
                 std::logic_error);
  }

  TEST_F(TwoTriangles, HaveSpringsAloneUntilSomethingIsAdded)
  {
    EXPECT_TRUE(has_springs_alone(builder.build().families));
    builder.add(angles_at_rest(points(lower),
                               {{0, 1, 2}},
                               Eigen::VectorXd::Ones(1)),
                lower);
    EXPECT_FALSE(has_springs_alone(builder.build().families));
  }

  TEST_F(TwoTriangles, VolumesKeepTheirNodes)
  {
    for (const auto &[cell, k] : {std::pair{lower, 7.}, std::pair{upper, 8.}})
      builder.add(volume_at_rest(points(cell), CellKind::triangle, k), cell);
    EXPECT_EQ(found("volumes"), (Found{{lower, 7.}, {upper, 8.}}));
    EXPECT_EQ(column("volumes", 1), (std::vector<double>{1., 1.}));
  }

  TEST_F(TwoTriangles, ConstantsAreThoseOfOneMemberAfterTheOther)
  {
    builder.add(volume_at_rest(points(lower), CellKind::triangle, 7.), lower);
    const Families families = builder.build().families;
    Eigen::VectorXd c(6);
    c << 1., 2., -27., 20., 10., 7.;
    EXPECT_EQ(constants_of(families), c);
    const Families others = with_constants(families, 2. * c);
    EXPECT_EQ(constants_of(others), 2. * c);
    EXPECT_TRUE(all_finite(others));
    EXPECT_THROW(with_constants(families, c.head(5)), std::logic_error);
    c[3] = std::nan("");
    EXPECT_FALSE(all_finite(with_constants(families, c)));
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
        const Eigen::MatrixXd x = nodes(Eigen::all, cell);
        builder.add(lengths_at_rest(x, pairs, k, SpringLaw::quadratic), cell);
        const Eigen::MatrixXd B = length_gradients(x, pairs);
        K.block<24, 24>(3 * cell[0], 3 * cell[0]) +=
          B * k.asDiagonal() * B.transpose();
      }

    const SpringNetwork network = builder.build();
    ASSERT_EQ(network.families.size(), 1u);
    const Family &family = network.families[0];
    std::vector<NodePair> springs;
    for (std::size_t s = 0; s < family.size(); ++s)
      springs.push_back({{family.nodes(s)[0], family.nodes(s)[1]}});
    EXPECT_EQ(springs.size(), 28u + 28u - 6u);
    const Eigen::MatrixXd B = length_gradients(nodes, springs);
    const Eigen::VectorXd k = spring_stiffness(network.families);
    EXPECT_LT((K - B * k.asDiagonal() * B.transpose()).norm(), 1e-13);
    EXPECT_LT((Eigen::MatrixXd(tangent(network.families, nodes)) - K).norm(),
              1e-13);
  }
} // namespace
