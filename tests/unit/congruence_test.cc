#include <springfit/calibration/congruence.h>
#include <springfit/springs/cell_topology.h>

#include <gtest/gtest.h>

#include <set>

#include "cells.h"

using namespace springfit;
using springfit::oracle::all_kinds;
using springfit::oracle::Random;

namespace
{
  Eigen::MatrixXd
  renumbered(const Eigen::MatrixXd &x, const std::vector<unsigned int> &p)
  {
    Eigen::MatrixXd y(x.rows(), x.cols());
    for (int v = 0; v < x.cols(); ++v)
      y.col(p[v]) = x.col(v);
    return y;
  }

  Eigen::MatrixXd
  mirrored(Eigen::MatrixXd x)
  {
    x.row(0) *= -1.;
    return x;
  }

  Eigen::MatrixXd
  moved(const Eigen::MatrixXd &x, Random &random)
  {
    const Eigen::MatrixXd rotated = random.rotation(x.rows()) * x;
    return rotated.colwise() + Eigen::VectorXd(random.matrix(x.rows(), 1));
  }

  void
  expect_same_shape(const Eigen::MatrixXd &x,
                    const Eigen::MatrixXd &y,
                    const CellKind kind)
  {
    const auto a = canonical_shape(x, kind);
    const auto b = canonical_shape(y, kind);
    EXPECT_EQ(a.key.lengths, b.key.lengths);
    EXPECT_TRUE(a.key == b.key);
    EXPECT_EQ(std::hash<ShapeKey>()(a.key), std::hash<ShapeKey>()(b.key));
  }

  TEST(Congruence, CopiesOfRandomCellsAreRecognised)
  {
    Random random(20);
    for (const CellKind kind : all_kinds)
      for (unsigned int cell = 0; cell < 20; ++cell)
        {
          const Eigen::MatrixXd x = oracle::random_cell(kind, random);
          expect_same_shape(x, moved(x, random), kind);
          expect_same_shape(x, mirrored(x), kind);
          expect_same_shape(x, 0.0025 * x, kind);
          for (const auto &p : symmetries(kind))
            expect_same_shape(x,
                              17. * moved(mirrored(renumbered(x, p)), random),
                              kind);
        }
  }

  TEST(Congruence, CopiesOfRegularCellsAreRecognised)
  {
    // Here rounding errors meet the limits of the integers if anywhere.
    Random random(21);
    for (const CellKind kind : all_kinds)
      for (unsigned int copy = 0; copy < 500; ++copy)
        {
          const Eigen::MatrixXd x = oracle::regular_cell(kind);
          expect_same_shape(x, random(0.001, 10.) * moved(x, random), kind);
        }
  }

  TEST(Congruence, OtherShapesDiffer)
  {
    Random random(22);
    for (const CellKind kind : all_kinds)
      {
        std::set<std::vector<std::int64_t>> keys;
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        keys.insert(canonical_shape(x, kind).key.lengths);
        // One coordinate changed by a millionth.
        for (int entry = 0; entry < x.size(); ++entry)
          {
            Eigen::MatrixXd y = x;
            y(entry) += 1e-6;
            keys.insert(canonical_shape(y, kind).key.lengths);
          }
        EXPECT_EQ(keys.size(), x.size() + 1u);
      }
  }

  TEST(Congruence, StretchedCellsDiffer)
  {
    for (const CellKind kind : all_kinds)
      {
        const Eigen::MatrixXd x = oracle::regular_cell(kind);
        Eigen::MatrixXd y       = x;
        y.row(0) *= 1.001;
        EXPECT_TRUE(canonical_shape(x, kind).key !=
                    canonical_shape(y, kind).key);
      }
  }

  TEST(Congruence, KindsDiffer)
  {
    // A flat tetrahedron in place of a square has the same distances.
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(3, 4);
    x.topRows(2)      = oracle::regular_cell(CellKind::quadrilateral);
    auto a            = canonical_shape(x, CellKind::tetrahedron).key;
    auto b            = a;
    b.kind            = CellKind::quadrilateral;
    EXPECT_TRUE(a != b);
  }

  TEST(Congruence, TheBowTieOfASquareIsAnotherCell)
  {
    // The vertices of a square in an order that is none of its symmetries.
    const Eigen::MatrixXd x = oracle::regular_cell(CellKind::quadrilateral);
    const Eigen::MatrixXd y = renumbered(x, {0, 1, 3, 2});
    EXPECT_TRUE(canonical_shape(x, CellKind::quadrilateral).key !=
                canonical_shape(y, CellKind::quadrilateral).key);
  }

  TEST(Congruence, PermutationsLeadToTheCanonicalNumbering)
  {
    Random random(23);
    for (const CellKind kind : all_kinds)
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const auto shape        = canonical_shape(x, kind);
        const auto &pairs       = node_pairs(kind);
        EXPECT_NEAR(
          shape.size,
          [&]() {
            double largest = 0.;
            for (const auto &[i, j] : pairs)
              largest = std::max(largest, (x.col(j) - x.col(i)).norm());
            return largest;
          }(),
          1e-14);
        for (std::size_t s = 0; s < pairs.size(); ++s)
          {
            const auto [a, b] = pairs[s];
            const double length =
              (x.col(shape.permutation[b]) - x.col(shape.permutation[a]))
                .norm();
            EXPECT_NEAR(length / shape.size, 1e-9 * shape.key.lengths[s], 2e-9);
          }
      }
  }
} // namespace
