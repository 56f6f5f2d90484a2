// Members of families: the order of their nodes, and those without derivatives.

#include <springfit/springs/angles.h>
#include <springfit/springs/couplings.h>
#include <springfit/springs/lengths.h>
#include <springfit/springs/network.h>
#include <springfit/springs/point_volumes.h>
#include <springfit/springs/volume.h>
#include <springfit/springs/volumes.h>
#include <springfit/springs/zero_lengths.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "cells.h"
#include "families.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
  // The order of a member's nodes.

  TEST(Canonicalise, PutsEndsInOrder)
  {
    const auto check = [](const SpringKind &kind,
                          Nodes nodes,
                          Numbers numbers,
                          const Nodes &expected,
                          const Numbers &expected_numbers) {
      Random random(411);
      const Eigen::MatrixXd x = random.matrix(dimension_of(kind), 9);
      Family before(kind), after(kind);
      before.add(nodes, numbers);
      kind.canonicalise(nodes, numbers, x);
      after.add(nodes, numbers);
      EXPECT_EQ(nodes, expected);
      EXPECT_EQ(numbers, expected_numbers);
      EXPECT_DOUBLE_EQ(energy_of(before, x), energy_of(after, x));
      EXPECT_LT(distance(forces_of(after, x), forces_of(before, x)), 1e-14);
    };
    for (const int dim : {2, 3})
      {
        for (const SpringLaw law : laws)
          {
            check(
              lengths(dim, law), {4, 2}, {{2.}, {3.}}, {2, 4}, {{2.}, {3.}});
            check(
              lengths(dim, law), {2, 4}, {{2.}, {3.}}, {2, 4}, {{2.}, {3.}});
            const SpringKind &kind = couplings(dim, law);
            check(kind,
                  {7, 2, 3, 1},
                  {{2.}, {3.}, {4.}},
                  {1, 3, 2, 7},
                  {{2.}, {4.}, {3.}});
            check(kind,
                  {3, 1, 2, 1},
                  {{2.}, {3.}, {4.}},
                  {1, 2, 1, 3},
                  {{2.}, {4.}, {3.}});
            check(kind,
                  {1, 2, 7, 3},
                  {{2.}, {3.}, {4.}},
                  {1, 2, 3, 7},
                  {{2.}, {3.}, {4.}});
          }
        check(zero_lengths(dim), {4, 2}, {{2.}, {0.}}, {2, 4}, {{2.}, {0.}});
        check(angles(dim), {5, 8, 1}, {{2.}, {1.}}, {1, 8, 5}, {{2.}, {1.}});
        check(angles(dim), {1, 8, 5}, {{2.}, {1.}}, {1, 8, 5}, {{2.}, {1.}});
      }
  }

  /** The cell of a kind of spring, if its coordinates are volumes. */
  std::vector<CellKind>
  cell_of(const SpringKind &kind)
  {
    for (const CellKind cell : oracle::all_kinds)
      {
        if (&kind == &volumes(cell) || &kind == &logarithmic_volumes(cell))
          return {cell};
        if (dimension(cell) == 2 &&
            &kind == &logarithmic_areas_in_plane_stress(cell))
          return {cell};
        if (is_simplex(cell))
          continue;
        if (&kind == &point_volumes(cell) ||
            &kind == &logarithmic_point_volumes(cell))
          return {cell};
        if (dimension(cell) == 2 &&
            &kind == &logarithmic_point_areas_in_plane_stress(cell))
          return {cell};
      }
    return {};
  }

  /** Every numbering of a cell, also inside out, is the same spring. */
  TEST(Canonicalise, TurnsMirroredCells)
  {
    Random random(412);
    unsigned int n_kinds = 0;
    for_every_kind([&](const SpringKind &kind) {
      for (const CellKind cell : cell_of(kind))
        {
          ++n_kinds;
          const auto [family, rest] = random_sample(kind, 1, random, 1);
          const Eigen::MatrixXd x =
            rest + 0.05 * random.matrix(rest.rows(), rest.cols());
          unsigned int n_mirrored = 0;
          for (const auto &p : symmetries(cell))
            {
              Nodes nodes(p.size());
              Numbers numbers = family.numbers(0);
              for (unsigned int v = 0; v < p.size(); ++v)
                {
                  nodes[p[v]] = v;
                  for (std::size_t c = 0; c < numbers.size(); ++c)
                    if (numbers[c].size() > 1)
                      numbers[c][p[v]] = family.numbers(0)[c][v];
                }
              const Nodes given = nodes;
              n_mirrored += volume(rest(Eigen::all, given), cell) < 0.;
              kind.canonicalise(nodes, numbers, rest);
              EXPECT_GT(volume(rest(Eigen::all, nodes), cell), 0.);
              if (volume(rest(Eigen::all, given), cell) > 0.)
                EXPECT_EQ(nodes, given);
              Family other(kind);
              other.add(nodes, numbers);
              const double U = energy_of(family, x);
              EXPECT_NEAR(energy_of(other, x), U, 1e-13 * (1. + std::abs(U)));
              expect_the_same(other, family, x, random);
            }
          EXPECT_EQ(n_mirrored, symmetries(cell).size() / 2);
        }
    });
    EXPECT_EQ(n_kinds, 15u);
  }


  // Members without derivatives.

  /**
   * A member that lacks derivatives costs infinite energy and is left out of
   * everything else.
   *
   * @param x places at which the member of the first nodes lacks them
   */
  void
  expect_left_out(const SpringKind &kind,
                  const Eigen::MatrixXd &degenerate,
                  Random &random)
  {
    SCOPED_TRACE(name_of(kind));
    const int n = kind.n_nodes();
    // With others before and after it, as many as lanes might take at once.
    auto [family, x] = random_sample(kind, 9, random);
    for (std::size_t bad = 0; bad < 3; ++bad)
      {
        Eigen::MatrixXd places        = x;
        places.middleCols(n * bad, n) = degenerate;
        std::vector<std::size_t> good;
        for (std::size_t m = 0; m < family.size(); ++m)
          if (m % 3 != bad)
            good.push_back(m);
          else
            {
              EXPECT_TRUE(kind.hessian(family.members, m, places).isZero(0.));
              EXPECT_EQ(energy_of(selected(family, {m}), places),
                        std::numeric_limits<double>::infinity());
              EXPECT_TRUE(forces_of(selected(family, {m}), places).isZero(0.));
            }
        EXPECT_EQ(energy_of(family, places),
                  std::numeric_limits<double>::infinity());
        EXPECT_TRUE(std::isfinite(energy_of(selected(family, good), places)));
        EXPECT_EQ(energy({family}, places),
                  std::numeric_limits<double>::infinity());
        expect_the_same(family, selected(family, good), places, random);
      }
  }

  TEST(Degenerate, CoincidentNodesUnderTheQuadraticLaw)
  {
    Random random(413);
    for (const int dim : {2, 3})
      {
        Eigen::MatrixXd pair = random.matrix(dim, 2);
        pair.col(1)          = pair.col(0);
        expect_left_out(lengths(dim, SpringLaw::quadratic), pair, random);
        for (const int moved : {1, 3})
          {
            Eigen::MatrixXd x = random.matrix(dim, 4);
            x.col(moved)      = x.col(moved - 1);
            expect_left_out(couplings(dim, SpringLaw::quadratic), x, random);
          }

        // The other laws have no such places.
        for (const SpringKind *kind :
             {&lengths(dim, SpringLaw::biquadratic), &zero_lengths(dim)})
          {
            Family family(*kind);
            family.add({0, 1}, {{3.}, {0.5}});
            EXPECT_TRUE(std::isfinite(energy_of(family, pair)));
            EXPECT_TRUE(forces_of(family, pair).isZero(0.));
            EXPECT_GT(tangent_of(family, pair).norm(), 1.);
          }
      }
  }

  TEST(Degenerate, StraightAndFoldedAngles)
  {
    Random random(414);
    for (const int dim : {2, 3})
      for (const double at : {-1.5, 0., 2.})
        {
          Eigen::MatrixXd x = random.matrix(dim, 3);
          x.col(2)          = x.col(1) + at * (x.col(0) - x.col(1));
          expect_left_out(angles(dim), x, random);
        }
  }

  TEST(Degenerate, InvertedCellsUnderTheLogarithmicLaws)
  {
    Random random(415);
    unsigned int n_kinds = 0;
    for_every_kind([&](const SpringKind &kind) {
      for (const CellKind cell : cell_of(kind))
        {
          const bool logarithmic   = kind.word().find("logarithmic") == 0;
          Eigen::MatrixXd inverted = random_places(kind, random);
          inverted.row(0) *= -1.;
          Eigen::MatrixXd flat = random_places(kind, random);
          flat.row(0).setZero();
          if (logarithmic)
            {
              ++n_kinds;
              expect_left_out(kind, inverted, random);
              expect_left_out(kind, flat, random);
              continue;
            }
          Family family(kind);
          family.add(first_nodes(kind.n_nodes()), random_numbers(kind, random));
          EXPECT_TRUE(std::isfinite(energy_of(family, inverted)));
          EXPECT_GT(forces_of(family, inverted).norm(), 1e-3);
          EXPECT_LT(volume(inverted, cell), 0.);
        }
    });
    EXPECT_EQ(n_kinds, 9u);
  }

  /** A cell may be inside out at one of its points and large all the same. */
  TEST(Degenerate, CellsInvertedAtAPoint)
  {
    Random random(416);
    Eigen::MatrixXd square = oracle::regular_cell(CellKind::quadrilateral);
    square.col(0) << 0.9, 0.9;
    EXPECT_GT(volume(square, CellKind::quadrilateral), 0.);
    expect_left_out(logarithmic_point_volumes(CellKind::quadrilateral),
                    square,
                    random);
    expect_left_out(logarithmic_point_areas_in_plane_stress(
                      CellKind::quadrilateral),
                    square,
                    random);
    Eigen::MatrixXd cube = oracle::regular_cell(CellKind::hexahedron);
    cube.col(0) << 0.9, 0.9, 0.9;
    EXPECT_GT(volume(cube, CellKind::hexahedron), 0.);
    expect_left_out(logarithmic_point_volumes(CellKind::hexahedron),
                    cube,
                    random);
  }
} // namespace
