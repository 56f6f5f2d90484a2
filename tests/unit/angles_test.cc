// Angles: the coordinate of angular springs, and which of them a cell has.

#include <springfit/core/error.h>
#include <springfit/springs/angle.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/gradients.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "cells.h"
#include "derivative.h"

using namespace springfit;
using oracle::all_kinds;
using oracle::derivative;
using oracle::Random;
using oracle::scalar;

namespace
{
  const double pi = std::acos(-1.);

  // Functions of three points (a, m, c), the columns of a matrix.

  template <int dim, typename F>
  auto
  at(const F &f, const Eigen::MatrixXd &points)
  {
    return f(Vector<dim>(points.col(0) - points.col(1)),
             Vector<dim>(points.col(2) - points.col(1)));
  }

  template <int dim>
  double
  angle_of(const Eigen::MatrixXd &points)
  {
    return at<dim>(angle<dim>, points);
  }

  template <int dim>
  void
  check_known_angles()
  {
    for (const double degrees : {0., 1e-7, 30., 90., 135., 180. - 1e-7, 180.})
      {
        const double theta = degrees * pi / 180.;
        Vector<dim> u = Vector<dim>::Zero(), v = Vector<dim>::Zero();
        u[0]         = 3.;
        v.head(2)[0] = 0.5 * std::cos(theta);
        v.head(2)[1] = -0.5 * std::sin(theta);
        EXPECT_NEAR(angle<dim>(u, v), theta, 1e-15);
        EXPECT_NEAR(angle<dim>(v, u), theta, 1e-15);
        EXPECT_EQ(is_degenerate_angle<dim>(u, v),
                  degrees < 1e-5 || degrees > 180. - 1e-5);
        EXPECT_TRUE(is_degenerate_angle<dim>(u, Vector<dim>::Zero()));
      }
  }

  TEST(Angle, IsTheOneBetweenTheArms)
  {
    check_known_angles<2>();
    check_known_angles<3>();
  }

  template <int dim>
  void
  check_derivatives(const Eigen::MatrixXd &x)
  {
    const auto theta = [](const Eigen::MatrixXd &y) {
      return scalar(angle_of<dim>(y));
    };
    const auto gradient = [](const Eigen::MatrixXd &y) {
      return Eigen::VectorXd(at<dim>(angle_gradient<dim>, y));
    };
    const Eigen::MatrixXd H = at<dim>(angle_hessian<dim>, x);
    EXPECT_LT((derivative(theta, x).transpose() - gradient(x)).norm(),
              1e-7 * gradient(x).norm());
    EXPECT_LT((derivative(gradient, x) - H).norm(), 1e-7 * H.norm());
    EXPECT_LT((H - H.transpose()).norm(), 1e-14 * H.norm());
  }

  TEST(Angle, DerivativesAgreeWithDifferences)
  {
    Random random(41);
    for (int sample = 0; sample < 20; ++sample)
      {
        // Arms of length 0.2 to 1, at 6 degrees from straight or folded.
        const auto arms = [&](const int dim) {
          Eigen::MatrixXd x(dim, 3);
          do
            x = random.matrix(dim, 3);
          while ((x.col(0) - x.col(1)).norm() < 0.2 ||
                 (x.col(2) - x.col(1)).norm() < 0.2 ||
                 std::abs((x.col(0) - x.col(1))
                            .normalized()
                            .dot((x.col(2) - x.col(1)).normalized())) > 0.995);
          return x;
        };
        check_derivatives<2>(arms(2));
        check_derivatives<3>(arms(3));
      }
  }

  template <int dim>
  void
  check_invariance()
  {
    Random random(42);
    const Eigen::MatrixXd x = random.matrix(dim, 3);
    const Eigen::MatrixXd Q = random.rotation(dim);
    const Eigen::VectorXd t = random.matrix(dim, 1);
    Eigen::MatrixXd mirror  = Eigen::MatrixXd::Identity(dim, dim);
    mirror(0, 0)            = -1.;
    for (const Eigen::MatrixXd &F :
         {Q, Eigen::MatrixXd(mirror * Q), Eigen::MatrixXd(7. * Q)})
      EXPECT_NEAR(angle_of<dim>((F * x).colwise() + t),
                  angle_of<dim>(x),
                  1e-14);

    // Hence no forces and no moments on the whole, and none along the arms:
    // g . (S x + t) = 0 for skew S, and g . x = 0.
    const Eigen::VectorXd g = at<dim>(angle_gradient<dim>, x);
    const Eigen::Map<const Eigen::MatrixXd> forces(g.data(), dim, 3);
    const Eigen::MatrixXd moments = forces * x.transpose();
    EXPECT_LT(forces.rowwise().sum().norm(), 1e-14);
    EXPECT_LT((moments - moments.transpose()).norm(), 1e-14);
    EXPECT_NEAR(moments.trace(), 0., 1e-14);
  }

  TEST(Angle, RotationTranslationMirrorAndSizeChangeNothing)
  {
    check_invariance<2>();
    check_invariance<3>();
  }

  TEST(Angle, ThoseOfATriangleAddUpToPi)
  {
    Random random(43);
    for (const int dim : {2, 3})
      {
        const Eigen::MatrixXd x = random.matrix(dim, 3);
        double sum              = 0.;
        for (const auto &[a, m, c] : cell_angles(CellKind::triangle))
          {
            Eigen::MatrixXd y(dim, 3);
            y << x.col(a), x.col(m), x.col(c);
            sum += dim == 2 ? angle_of<2>(y) : angle_of<3>(y);
          }
        EXPECT_NEAR(sum, pi, 1e-14);
        const Eigen::MatrixXd G =
          angle_gradients(x, cell_angles(CellKind::triangle));
        EXPECT_LT(G.rowwise().sum().norm(), 1e-13);
      }
  }


  TEST(CellAngles, AreThoseOfTheFacesInOrder)
  {
    const std::map<CellKind, std::size_t> n_angles = {
      {CellKind::triangle, 3},
      {CellKind::quadrilateral, 4},
      {CellKind::tetrahedron, 12},
      {CellKind::hexahedron, 24}};
    for (const CellKind kind : all_kinds)
      {
        const auto &angles = cell_angles(kind);
        EXPECT_EQ(angles.size(), n_angles.at(kind));
        std::vector<NodeTriple> by_middle;
        for (const auto &[a, m, c] : angles)
          {
            EXPECT_LT(a, c);
            by_middle.push_back({{m, a, c}});
          }
        EXPECT_TRUE(std::is_sorted(by_middle.begin(), by_middle.end()));
        EXPECT_EQ(std::set<NodeTriple>(angles.begin(), angles.end()).size(),
                  angles.size());

        // The regular cells' faces have corners of 60 or 90 degrees.
        const Eigen::MatrixXd x = oracle::regular_cell(kind);
        for (const auto &[a, m, c] : angles)
          EXPECT_NEAR((x.col(a) - x.col(m)).dot(x.col(c) - x.col(m)),
                      is_simplex(kind) ? 0.5 : 0.,
                      1e-14);
      }
    EXPECT_EQ(
      cell_angles(CellKind::quadrilateral),
      (std::vector<NodeTriple>{{1, 0, 2}, {0, 1, 3}, {0, 2, 3}, {1, 3, 2}}));
    EXPECT_EQ(cell_angles(CellKind::tetrahedron)[3], (NodeTriple{0, 1, 2}));
  }

  TEST(CellAngles, GradientsAreTheSlopesOfTheAngles)
  {
    Random random(44);
    for (const CellKind kind : all_kinds)
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const auto &triples     = cell_angles(kind);
        // By the law of cosines.
        const auto angles = [&](const Eigen::MatrixXd &y) {
          Eigen::VectorXd theta(triples.size());
          for (std::size_t t = 0; t < triples.size(); ++t)
            {
              const auto [a, m, c] = triples[t];
              const double u       = (y.col(a) - y.col(m)).norm();
              const double v       = (y.col(c) - y.col(m)).norm();
              const double across  = (y.col(c) - y.col(a)).norm();
              theta[t] =
                std::acos((u * u + v * v - across * across) / (2. * u * v));
            }
          return theta;
        };
        const Eigen::MatrixXd G = angle_gradients(x, triples);
        ASSERT_EQ(G.rows(), x.size());
        ASSERT_EQ(G.cols(), int(triples.size()));
        EXPECT_LT((derivative(angles, x).transpose() - G).norm(), 1e-7);
      }
  }

  TEST(CellAngles, StraightAndFoldedOnesAreNamed)
  {
    Eigen::MatrixXd x = oracle::regular_cell(CellKind::quadrilateral);
    x.col(3)          = 0.5 * (x.col(1) + x.col(2)); // straight at 3
    try
      {
        angle_gradients(x, cell_angles(CellKind::quadrilateral));
        FAIL() << "a straight angle was taken";
      }
    catch (const RunError &error)
      {
        const std::string message = error.what();
        EXPECT_NE(message.find("vertex 3 between its vertices 1 and 2"),
                  std::string::npos)
          << message;
      }
    x.col(3) = 0.5 * (x.col(0) + x.col(1)); // folded at 1
    EXPECT_THROW(angle_gradients(x, {{0, 1, 3}}), RunError);
    x.col(3) = x.col(1);
    EXPECT_THROW(angle_gradients(x, {{0, 1, 3}}), RunError);
  }
} // namespace
