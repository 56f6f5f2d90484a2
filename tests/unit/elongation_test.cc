// The elongation of a spring by either law, and couplings of two of them.

#include <springfit/springs/couplings.h>
#include <springfit/springs/elongation.h>
#include <springfit/springs/gradients.h>

#include <gtest/gtest.h>

#include "cells.h"
#include "derivative.h"

using namespace springfit;
using springfit::oracle::derivative;
using springfit::oracle::Random;
using springfit::oracle::scalar;

namespace
{
  constexpr SpringLaw laws[] = {SpringLaw::quadratic, SpringLaw::biquadratic};

  /** Of points x_i, x_j. */
  template <int dim>
  Elongation<dim>
  elongation_of(const SpringLaw law,
                const double rest_length,
                const Eigen::MatrixXd &x,
                const int i,
                const int j)
  {
    return *elongation<dim>(law, rest_length, x.col(j) - x.col(i));
  }

  template <int dim>
  void
  check_elongation(const SpringLaw law)
  {
    Random random(51);
    const double L          = 0.7;
    const Eigen::MatrixXd x = random.matrix(dim, 2);
    const double l          = (x.col(1) - x.col(0)).norm();
    const auto q            = [&](const Eigen::MatrixXd &y) {
      return elongation_of<dim>(law, L, y, 0, 1);
    };
    EXPECT_NEAR(q(x).value(),
                law == SpringLaw::quadratic ? l - L
                                            : (l - L) * (l + L) / (2. * L),
                1e-14);
    const auto value = [&](const Eigen::MatrixXd &y) {
      return scalar(q(y).value());
    };
    const auto gradient = [&](const Eigen::MatrixXd &y) {
      return Eigen::VectorXd(q(y).gradient());
    };
    EXPECT_LT((derivative(value, x).transpose() - gradient(x)).norm(), 1e-8);
    EXPECT_LT((derivative(gradient, x) - q(x).hessian()).norm(), 1e-8);

    // At rest all laws are the same.
    const auto at_rest = elongation_of<dim>(law, l, x, 0, 1);
    EXPECT_NEAR(at_rest.value(), 0., 1e-15);
    EXPECT_LT(
      (at_rest.gradient() - length_gradients(x, {{{0, 1}}}).col(0)).norm(),
      1e-14);
  }

  TEST(Elongation, DerivativesAgreeWithDifferences)
  {
    for (const SpringLaw law : laws)
      {
        check_elongation<2>(law);
        check_elongation<3>(law);
      }
  }

  TEST(Elongation, OfCoincidentNodesHasADirectionInOneLawAlone)
  {
    const Vector<2> zero = Vector<2>::Zero();
    EXPECT_FALSE(elongation<2>(SpringLaw::quadratic, 2., zero));
    const auto q = elongation<2>(SpringLaw::biquadratic, 2., zero);
    ASSERT_TRUE(q);
    EXPECT_EQ(q->value(), -1.); // (0 - 4) / 4
  }


  /** Of the points i_a, j_a, i_b, j_b. */
  template <int dim>
  void
  check_coupling(const SpringLaw law)
  {
    Random random(24);
    const double stiffness = 3., L_a = 0.7, L_b = 1.6;
    const Eigen::MatrixXd x = random.matrix(dim, 4);
    const SpringKind &kind  = couplings(dim, law);
    Family family(kind);
    family.add({0, 1, 2, 3}, {{stiffness}, {L_a}, {L_b}});
    const auto energy = [&](const Eigen::MatrixXd &y) {
      return scalar(kind.energy(family.members, y));
    };
    const auto gradient = [&](const Eigen::MatrixXd &y) -> Eigen::VectorXd {
      Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(dim, 4);
      kind.add_forces(family.members, y, forces);
      return -forces.reshaped();
    };
    const Eigen::MatrixXd H = kind.hessian(family.members, 0, x);

    EXPECT_NEAR(energy(x)[0],
                stiffness * elongation_of<dim>(law, L_a, x, 0, 1).value() *
                  elongation_of<dim>(law, L_b, x, 2, 3).value(),
                1e-14);
    if (law == SpringLaw::quadratic)
      EXPECT_NEAR(energy(x)[0],
                  stiffness * ((x.col(1) - x.col(0)).norm() - L_a) *
                    ((x.col(3) - x.col(2)).norm() - L_b),
                  1e-14);
    EXPECT_LT((derivative(energy, x).transpose() - gradient(x)).norm(), 1e-8);
    EXPECT_LT((derivative(gradient, x) - H).norm(), 1e-8);

    const Eigen::MatrixXd Q = random.rotation(dim);
    const Eigen::VectorXd g = gradient(x), turned = gradient(Q * x);
    const Eigen::MatrixXd expected = Q * g.reshaped(dim, 4);
    EXPECT_NEAR(energy(Q * x)[0], energy(x)[0], 1e-14);
    EXPECT_LT((turned.reshaped(dim, 4) - expected).norm(), 1e-13);
  }

  TEST(Coupling, DerivativesAgreeWithDifferencesAndTurnWithTheNodes)
  {
    for (const SpringLaw law : laws)
      {
        check_coupling<2>(law);
        check_coupling<3>(law);
      }
  }
} // namespace
