// The stability limit of symplectic Euler's method, against dense eigenvalues
// and against what happens, for every kind of springs in a state under stress.

#include <springfit/motion/critical_step.h>
#include <springfit/response/network_body.h>
#include <springfit/springs/network.h>
#include <springfit/springs/spring_kinds.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "cells.h"

using namespace springfit;
using springfit::oracle::Random;

namespace
{
  /** A member that pulls, or pushes, its nodes. */
  Family
  stressed_member(const SpringKind &kind, Random &random)
  {
    std::vector<std::vector<double>> numbers;
    for (const auto &column : kind.columns())
      {
        numbers.emplace_back(column.width);
        for (double &number : numbers.back())
          number = column.role == Column::Role::rest_value
                     ? random(0.6, 0.8) / column.width
                     : random(0.6, 1.1);
      }
    std::vector<unsigned int> nodes(kind.n_nodes());
    std::iota(nodes.begin(), nodes.end(), 0);
    Family family(kind);
    family.add(nodes, numbers);
    return family;
  }

  int
  dimension_of(const SpringKind &kind)
  {
    Random random(1);
    const Family family     = stressed_member(kind, random);
    const Eigen::MatrixXd x = random.matrix(3, kind.n_nodes());
    return kind.hessian(family.members, 0, x).rows() / kind.n_nodes();
  }

  struct Example
  {
    Example(const SpringKind &kind, Random &random)
      : dim(dimension_of(kind))
      , nodes(random_places(kind, random))
      , families({stressed_member(kind, random)})
      , network(nodes, families)
      , rest(Eigen::MatrixXd::Zero(dim, nodes.cols()))
    {
      body.elastic = &network;
      body.mass    = Eigen::VectorXd(nodes.cols());
      for (double &mass : body.mass)
        mass = random(0.5, 2.);
      body.held.assign(nodes.size(), false);
      body.held[1] = true;
    }

    Eigen::MatrixXd
    random_places(const SpringKind &kind, Random &random) const
    {
      const int n = kind.n_nodes();
      const CellKind cell =
        n == 1 << dim
          ? (dim == 2 ? CellKind::quadrilateral : CellKind::hexahedron)
          : (dim == 2 ? CellKind::triangle : CellKind::tetrahedron);
      return oracle::regular_cell(cell).leftCols(n) +
             0.1 * random.matrix(dim, n);
    }

    /** Of the unknowns that are not held, M^(-1/2) (K or C) M^(-1/2). */
    Eigen::MatrixXd
    scaled(const Eigen::MatrixXd &matrix) const
    {
      std::vector<Eigen::Index> free;
      for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        if (!body.held[i])
          free.push_back(i);
      Eigen::VectorXd weights(matrix.rows());
      for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        weights[i] = 1. / std::sqrt(body.mass[i / dim]);
      const Eigen::MatrixXd all =
        weights.asDiagonal() * matrix * weights.asDiagonal();
      return all(free, free);
    }

    const int dim;
    const Eigen::MatrixXd nodes;
    const Families families;
    const NetworkBody network;
    const Eigen::MatrixXd rest;
    MovingBody body;
  };

  /** How much a linear motion grows in steps of symplectic Euler. */
  double
  growth(const Eigen::MatrixXd &K, const Eigen::MatrixXd &C, const double step)
  {
    Eigen::VectorXd u = Eigen::VectorXd::Ones(K.rows()), v = 0. * u;
    double largest = 0.;
    for (unsigned int i = 0; i < 4000 && largest < 1e9; ++i)
      {
        v -= step * (K * u + C * v);
        u += step * v;
        largest = std::max(largest, v.norm());
      }
    return largest;
  }
} // namespace

TEST(CriticalStep, of_every_kind_under_stress_is_that_of_dense_eigenvalues)
{
  Random random(12);
  unsigned int n_observed = 0;
  for (const SpringKind *kind : spring_kinds())
    for (unsigned int i = 0; i < 10; ++i)
      {
        SCOPED_TRACE(kind->word());
        Example example(*kind, random);
        const Eigen::MatrixXd K =
          example.scaled(tangent(example.families, example.nodes));
        const Eigen::VectorXd squares =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
        const double largest = squares.maxCoeff();
        if (largest < 1e-3 || squares.minCoeff() < -largest)
          continue;
        const double expected  = 2. / std::sqrt(largest);
        const double predicted = critical_step(example.body, example.rest).step;
        EXPECT_LE(predicted, 1.0001 * expected);
        EXPECT_GE(predicted, 0.98 * expected);

        if (squares.minCoeff() < -1e-10 * largest)
          continue; // which grows at any step
        const Eigen::MatrixXd none = 0. * K;
        EXPECT_LT(growth(K, none, 0.98 * predicted), 1e4);
        EXPECT_GT(growth(K, none, 1.02 * predicted), 1e8);
        ++n_observed;
      }
  EXPECT_GT(n_observed, 20u);
}

TEST(CriticalStep, with_damping_is_observed_and_dampers_are_on_the_safe_side)
{
  Random random(13);
  for (const SpringKind *kind : spring_kinds())
    {
      if (kind->n_nodes() != 2)
        continue;
      SCOPED_TRACE(kind->word());
      Example example(*kind, random);
      const Eigen::MatrixXd K =
        example.scaled(tangent(example.families, example.nodes));
      const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(K.rows(), K.cols());

      example.body.damping = {0.3, 0.2};
      double predicted     = critical_step(example.body, example.rest).step;
      Eigen::MatrixXd C    = 0.3 * M + 0.2 * K;
      EXPECT_LT(growth(K, C, 0.98 * predicted), 1e4);
      EXPECT_GT(growth(K, C, 1.02 * predicted), 1e8);

      example.body.damping = {};
      example.body.dampers = {0.7, {{{0, 1}}}, example.nodes};
      Eigen::MatrixXd of_dampers(example.nodes.size(), example.nodes.size());
      for (Eigen::Index i = 0; i < of_dampers.cols(); ++i)
        {
          Eigen::MatrixXd unit = example.rest;
          unit.reshaped()[i]   = 1.;
          of_dampers.col(i) =
            damper_product(example.body.dampers, example.rest, unit).reshaped();
        }
      predicted = critical_step(example.body, example.rest).step;
      EXPECT_LT(growth(K, example.scaled(of_dampers), 0.98 * predicted), 1e4);
    }
}
