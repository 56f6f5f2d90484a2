// Areas of surfaces and volumes of cells: coordinates of generalised springs.

#include <springfit/springs/area.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/rigid_modes.h>
#include <springfit/springs/volume.h>

#include <gtest/gtest.h>

#include <stdexcept>

#include "cells.h"
#include "derivative.h"

using namespace springfit;
using springfit::oracle::all_kinds;
using springfit::oracle::derivative;
using springfit::oracle::Random;
using springfit::oracle::scalar;

namespace
{
  TEST(Volume, OfKnownBodies)
  {
    const auto regular = [](const CellKind kind) {
      return volume(oracle::regular_cell(kind), kind);
    };
    EXPECT_NEAR(regular(CellKind::triangle), std::sqrt(3.) / 4., 1e-15);
    EXPECT_NEAR(regular(CellKind::quadrilateral), 1., 1e-15);
    EXPECT_NEAR(regular(CellKind::tetrahedron), std::sqrt(2.) / 12., 1e-15);
    EXPECT_NEAR(regular(CellKind::hexahedron), 1., 1e-15);

    // Gauss' shoelace formula; deal.II's last two vertices are swapped.
    Random random(21);
    const Eigen::MatrixXd x =
      oracle::random_cell(CellKind::quadrilateral, random);
    double twice                    = 0.;
    const std::array<int, 4> around = {0, 1, 3, 2};
    for (int v = 0; v < 4; ++v)
      {
        const int a = around[v], b = around[(v + 1) % 4];
        twice += x(0, a) * x(1, b) - x(0, b) * x(1, a);
      }
    EXPECT_NEAR(volume(x, CellKind::quadrilateral), twice / 2., 1e-15);

    // A frustum of a pyramid, height 1, between squares of side 2 and 1.
    Eigen::MatrixXd frustum = oracle::regular_cell(CellKind::hexahedron);
    for (int v = 0; v < 4; ++v)
      frustum.col(v).head(2) = 2. * frustum.col(v).head(2).array() - 0.5;
    EXPECT_NEAR(volume(frustum, CellKind::hexahedron),
                (4. + 2. + 1.) / 3.,
                1e-14);
  }

  TEST(Volume, DerivativesAgreeWithDifferences)
  {
    Random random(22);
    for (const CellKind kind : all_kinds)
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const auto V            = [&](const Eigen::MatrixXd &y) {
          return scalar(volume(y, kind));
        };
        const auto gradient = [&](const Eigen::MatrixXd &y) {
          return volume_gradient(y, kind);
        };
        const Eigen::MatrixXd H = volume_hessian(x, kind);
        EXPECT_LT((derivative(V, x).transpose() - gradient(x)).norm(), 1e-9);
        EXPECT_LT((derivative(gradient, x) - H).norm(), 1e-9);
        EXPECT_GT(H.norm(), 0.1);
      }
  }

  TEST(Volume, RigidMotionsChangeNothing)
  {
    Random random(23);
    for (const CellKind kind : all_kinds)
      {
        const int dim               = dimension(kind);
        const Eigen::MatrixXd x     = oracle::random_cell(kind, random);
        const Eigen::MatrixXd Q     = random.rotation(dim);
        const Eigen::VectorXd t     = random.matrix(dim, 1);
        const Eigen::MatrixXd moved = (Q * x).colwise() + t;
        EXPECT_NEAR(volume(moved, kind), volume(x, kind), 1e-14);
        EXPECT_LT(
          (rigid_body_modes(x).transpose() * volume_gradient(x, kind)).norm(),
          1e-14);
        // A mirror image is inside out.
        Eigen::MatrixXd mirrored = x;
        mirrored.row(0) *= -1.;
        EXPECT_NEAR(volume(mirrored, kind), -volume(x, kind), 1e-14);
      }
  }

  TEST(Volume, TheNumberOfVerticesTellsTheKind)
  {
    for (const CellKind kind : all_kinds)
      EXPECT_EQ(cell_kind(dimension(kind), n_vertices(kind)), kind);
    EXPECT_THROW(cell_kind(2, 8), std::logic_error);
  }


  const CellKind surfaces[] = {CellKind::triangle, CellKind::quadrilateral};

  /** A plane cell, lifted out of its plane at random. */
  Eigen::MatrixXd
  random_surface(const CellKind kind, Random &random)
  {
    Eigen::MatrixXd points(3, n_vertices(kind));
    points.topRows(2)    = oracle::random_cell(kind, random);
    points.bottomRows(1) = 0.4 * random.matrix(1, points.cols());
    return points;
  }

  TEST(Area, OfKnownSurfaces)
  {
    Random random(31);
    // Plane ones have that of the cell in 2-d.
    for (const CellKind kind : surfaces)
      {
        Eigen::MatrixXd flat(3, n_vertices(kind));
        flat.topRows(2) = oracle::random_cell(kind, random);
        flat.bottomRows(1).setZero();
        const Eigen::MatrixXd Q = random.rotation(3);
        EXPECT_NEAR(area(Q * flat, kind), volume(flat.topRows(2), kind), 1e-14);
      }
    // Heron's formula.
    const Eigen::MatrixXd x = random.matrix(3, 3);
    const double a          = (x.col(1) - x.col(0)).norm(),
                 b          = (x.col(2) - x.col(1)).norm(),
                 c = (x.col(0) - x.col(2)).norm(), s = 0.5 * (a + b + c);
    EXPECT_NEAR(area(x, CellKind::triangle),
                std::sqrt(s * (s - a) * (s - b) * (s - c)),
                1e-14);
    // z = h x y over the unit square: the integral of
    // sqrt(1 + h^2 (x^2 + y^2)) is 1 + h^2 / 3 - 7 h^4 / 90 + ...
    const double h         = 1e-2;
    Eigen::MatrixXd saddle = Eigen::MatrixXd::Zero(3, 4);
    saddle.topRows(2)      = oracle::regular_cell(CellKind::quadrilateral);
    saddle(2, 3)           = h;
    EXPECT_NEAR(area(saddle, CellKind::quadrilateral) - 1.,
                h * h / 3.,
                0.1 * h * h * h * h);
  }

  TEST(Area, DoesNotDependOnTheNumbering)
  {
    Random random(32);
    for (const CellKind kind : surfaces)
      {
        const Eigen::MatrixXd x = random_surface(kind, random);
        for (const auto &p : symmetries(kind))
          {
            Eigen::MatrixXd y(3, x.cols());
            for (Eigen::Index v = 0; v < x.cols(); ++v)
              y.col(p[v]) = x.col(v);
            EXPECT_NEAR(area(y, kind), area(x, kind), 1e-14);
          }
      }
  }

  TEST(Area, DerivativesAgreeWithDifferences)
  {
    Random random(33);
    for (const CellKind kind : surfaces)
      {
        const Eigen::MatrixXd x = random_surface(kind, random);
        const auto A            = [&](const Eigen::MatrixXd &y) {
          return scalar(area(y, kind));
        };
        const auto gradient = [&](const Eigen::MatrixXd &y) {
          return area_gradient(y, kind);
        };
        const Eigen::MatrixXd H = area_hessian(x, kind);
        EXPECT_LT((derivative(A, x).transpose() - gradient(x)).norm(), 1e-9);
        EXPECT_LT((derivative(gradient, x) - H).norm(), 1e-8);
        EXPECT_LT((H - H.transpose()).norm(), 1e-14);
      }
  }

  TEST(Area, RigidMotionsChangeNothing)
  {
    Random random(34);
    for (const CellKind kind : surfaces)
      {
        const Eigen::MatrixXd x = random_surface(kind, random);
        const Eigen::MatrixXd Q = random.rotation(3);
        const Eigen::VectorXd t = random.matrix(3, 1);
        EXPECT_NEAR(area((Q * x).colwise() + t, kind), area(x, kind), 1e-14);
        EXPECT_NEAR(area(-x, kind), area(x, kind), 1e-14);
        EXPECT_NEAR(area(3. * x, kind), 9. * area(x, kind), 1e-13);
        const Eigen::VectorXd g = area_gradient(x, kind);
        EXPECT_LT((rigid_body_modes(x).transpose() * g).norm(), 1e-14);
      }
  }
} // namespace
