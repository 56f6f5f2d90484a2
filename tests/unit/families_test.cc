// The kinds of springs: what each does for a family of members, one against
// the other and against what the coordinates and materials demand.

#include <springfit/springs/angles.h>
#include <springfit/springs/cell_quadrature.h>
#include <springfit/springs/cell_topology.h>
#include <springfit/springs/couplings.h>
#include <springfit/springs/gradients.h>
#include <springfit/springs/lengths.h>
#include <springfit/springs/network.h>
#include <springfit/springs/point_volumes.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/rigid_modes.h>
#include <springfit/springs/spring_kinds.h>
#include <springfit/springs/volume.h>
#include <springfit/springs/volumes.h>
#include <springfit/springs/zero_lengths.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "cells.h"
#include "derivative.h"

using namespace springfit;
using springfit::oracle::derivative;
using springfit::oracle::Random;
using springfit::oracle::scalar;

namespace
{
  using Nodes   = std::vector<unsigned int>;
  using Numbers = std::vector<std::vector<double>>;

  constexpr SpringLaw laws[] = {SpringLaw::quadratic, SpringLaw::biquadratic};

  Nodes
  first_nodes(const unsigned int n)
  {
    Nodes nodes(n);
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  }

  /**
   * Stiffness of either sign; rest values near one, of several coordinates of a
   * member that sum to near one; other numbers positive and of a similar size.
   */
  Numbers
  random_numbers(const SpringKind &kind, Random &random)
  {
    Numbers numbers;
    for (const auto &column : kind.columns())
      {
        numbers.emplace_back(column.width);
        for (double &number : numbers.back())
          switch (column.role)
            {
              case Column::Role::stiffness:
                number = random(-1., 1.);
                break;
              case Column::Role::rest_value:
                number = random(0.7, 1.3) / column.width;
                break;
              case Column::Role::parameter:
                number = random(0.6, 1.1);
                break;
            }
      }
    return numbers;
  }

  /** From the size of a member's Hessian. */
  int
  dimension_of(const SpringKind &kind)
  {
    Random random(400);
    Family family(kind);
    family.add(first_nodes(kind.n_nodes()), random_numbers(kind, random));
    const Eigen::MatrixXd x = random.matrix(3, kind.n_nodes());
    return kind.hessian(family.members, 0, x).rows() / kind.n_nodes();
  }

  std::string
  name_of(const SpringKind &kind)
  {
    return kind.word() + " of " + std::to_string(kind.n_nodes()) +
           " nodes in " + std::to_string(dimension_of(kind)) + "-d";
  }

  /** Places near those of a regular cell's vertices, or of some of them. */
  Eigen::MatrixXd
  random_places(const SpringKind &kind, Random &random)
  {
    const int dim = dimension_of(kind), n = kind.n_nodes();
    const CellKind cell =
      n == 1 << dim
        ? (dim == 2 ? CellKind::quadrilateral : CellKind::hexahedron)
        : (dim == 2 ? CellKind::triangle : CellKind::tetrahedron);
    const Eigen::MatrixXd regular = oracle::regular_cell(cell).leftCols(n);
    return regular + 0.15 * random.matrix(dim, n);
  }

  struct Sample
  {
    Family family;
    Eigen::MatrixXd x;
  };

  /** Members that share cells of nodes. */
  Sample
  random_sample(const SpringKind &kind,
                const unsigned int n_members,
                Random &random,
                const unsigned int n_cells = 3)
  {
    const int dim = dimension_of(kind), n = kind.n_nodes();
    Sample sample{Family(kind), Eigen::MatrixXd(dim, n * n_cells)};
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      sample.x.middleCols(n * cell, n) = random_places(kind, random);
    for (unsigned int m = 0; m < n_members; ++m)
      {
        Nodes nodes = first_nodes(n);
        for (unsigned int &node : nodes)
          node += n * (m % n_cells);
        sample.family.add(nodes, random_numbers(kind, random));
      }
    return sample;
  }

  Eigen::MatrixXd
  zero_like(const Eigen::MatrixXd &x)
  {
    return Eigen::MatrixXd::Zero(x.rows(), x.cols());
  }

  double
  energy_of(const Family &family, const Eigen::MatrixXd &x)
  {
    return family.kind->energy(family.members, x);
  }

  Eigen::MatrixXd
  forces_of(const Family &family, const Eigen::MatrixXd &x)
  {
    Eigen::MatrixXd forces = zero_like(x);
    family.kind->add_forces(family.members, x, forces);
    return forces;
  }

  Eigen::MatrixXd
  product_of(const Family &family,
             const Eigen::MatrixXd &x,
             const Eigen::MatrixXd &u)
  {
    Eigen::MatrixXd product = zero_like(x);
    family.kind->add_tangent_product(family.members, x, u, product);
    return product;
  }

  /** Column by column of add_tangent_product(). */
  Eigen::MatrixXd
  tangent_by_products(const Family &family, const Eigen::MatrixXd &x)
  {
    Eigen::MatrixXd K(x.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      {
        Eigen::MatrixXd u = zero_like(x);
        u.data()[i]       = 1.;
        K.col(i)          = product_of(family, x, u).reshaped();
      }
    return K;
  }

  TangentMatrix
  empty_tangent(const Family &family, const Eigen::MatrixXd &x)
  {
    NodePattern pattern(x.cols());
    add_to_pattern({family}, pattern);
    return TangentMatrix(x.rows(), pattern);
  }

  Eigen::MatrixXd
  tangent_of(const Family &family, const Eigen::MatrixXd &x)
  {
    TangentMatrix tangent = empty_tangent(family, x);
    family.kind->add_tangent(family.members, x, tangent);
    return tangent.matrix();
  }

  Eigen::MatrixXd
  convex_tangent_of(const Family &family, const Eigen::MatrixXd &x)
  {
    TangentMatrix tangent = empty_tangent(family, x);
    family.kind->add_convex_tangent(family.members, x, tangent);
    return tangent.matrix();
  }

  Eigen::MatrixXd
  diagonal_blocks_of(const Family &family, const Eigen::MatrixXd &x)
  {
    Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(x.rows(), x.size());
    family.kind->add_diagonal_blocks(family.members, x, blocks);
    return blocks;
  }

  /** The sum of matrices of members, each with respect to its own nodes. */
  template <typename OfMember>
  Eigen::MatrixXd
  assembled(const Family &family,
            const Eigen::MatrixXd &x,
            const OfMember &of_member)
  {
    const int dim     = x.rows();
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
    for (std::size_t m = 0; m < family.size(); ++m)
      {
        const Eigen::MatrixXd H = of_member(m);
        for (unsigned int a = 0; a < family.kind->n_nodes(); ++a)
          for (unsigned int b = 0; b < family.kind->n_nodes(); ++b)
            K.block(dim * family.nodes(m)[a],
                    dim * family.nodes(m)[b],
                    dim,
                    dim) += H.block(dim * a, dim * b, dim, dim);
      }
    return K;
  }

  /** The difference relative to the size of the expected one. */
  double
  distance(const Eigen::MatrixXd &found, const Eigen::MatrixXd &expected)
  {
    return (found - expected).norm() / (1. + expected.norm());
  }

  /** Every operation on @p family must be that on @p expected. */
  void
  expect_the_same(const Family &family,
                  const Family &expected,
                  const Eigen::MatrixXd &x,
                  Random &random)
  {
    const Eigen::MatrixXd u = random.matrix(x.rows(), x.cols());
    EXPECT_LT(distance(forces_of(family, x), forces_of(expected, x)), 1e-13);
    EXPECT_LT(distance(product_of(family, x, u), product_of(expected, x, u)),
              1e-13);
    EXPECT_LT(distance(tangent_of(family, x), tangent_of(expected, x)), 1e-13);
    EXPECT_LT(distance(convex_tangent_of(family, x),
                       convex_tangent_of(expected, x)),
              1e-13);
    EXPECT_LT(distance(diagonal_blocks_of(family, x),
                       diagonal_blocks_of(expected, x)),
              1e-13);
  }

  /** Runs a check on every kind that there is. */
  template <typename Check>
  void
  for_every_kind(const Check &check)
  {
    for (const SpringKind *kind : spring_kinds())
      {
        SCOPED_TRACE(name_of(*kind));
        check(*kind);
      }
  }


  // What every kind must keep.

  TEST(Families, EveryKindIsListedOnceAndUnderItsNumber)
  {
    for (std::size_t i = 0; i < spring_kinds().size(); ++i)
      EXPECT_EQ(number_of(*spring_kinds()[i]), i);
  }

  TEST(Families, ForcesAreTheEnergysSlopeAndTheTangentIsTheirs)
  {
    Random random(401);
    for_every_kind([&](const SpringKind &kind) {
      for (int repetition = 0; repetition < 3; ++repetition)
        {
          const auto [family, x] = random_sample(kind, 5, random);
          ASSERT_TRUE(std::isfinite(energy_of(family, x)));
          const auto energy = [f = family](const Eigen::MatrixXd &y) {
            return scalar(energy_of(f, y));
          };
          const auto gradient =
            [f = family](const Eigen::MatrixXd &y) -> Eigen::VectorXd {
            return -forces_of(f, y).reshaped();
          };
          EXPECT_GT(forces_of(family, x).norm(), 1e-3);
          EXPECT_LT(distance(gradient(x), derivative(energy, x).transpose()),
                    1e-7);
          EXPECT_LT(distance(tangent_by_products(family, x),
                             derivative(gradient, x)),
                    1e-7);
        }
    });
  }

  TEST(Families, AllFormsOfTheTangentAgree)
  {
    Random random(402);
    for_every_kind([&](const SpringKind &kind) {
      const auto [family, x]  = random_sample(kind, 7, random);
      const int dim           = x.rows();
      const Eigen::MatrixXd K = tangent_by_products(family, x);
      EXPECT_LT(distance(tangent_of(family, x), K), 1e-13);
      EXPECT_LT(distance(Eigen::MatrixXd(tangent({family}, x)), K), 1e-13);
      EXPECT_LT(distance(assembled(family,
                                   x,
                                   [f = family, y = x](const std::size_t m) {
                                     return f.kind->hessian(f.members, m, y);
                                   }),
                         K),
                1e-13);
      const Eigen::MatrixXd blocks = diagonal_blocks_of(family, x);
      for (Eigen::Index v = 0; v < x.cols(); ++v)
        EXPECT_LT(distance(blocks.middleCols(dim * v, dim),
                           K.block(dim * v, dim * v, dim, dim)),
                  1e-13);

      // What is there already remains.
      const Eigen::MatrixXd u     = random.matrix(dim, x.cols());
      const Eigen::MatrixXd start = random.matrix(dim, x.cols());
      Eigen::MatrixXd forces = start, product = start;
      kind.add_forces(family.members, x, forces);
      kind.add_tangent_product(family.members, x, u, product);
      EXPECT_LT(distance(forces - start, forces_of(family, x)), 1e-13);
      EXPECT_LT(distance(product - start, product_of(family, x, u)), 1e-13);
    });
  }

  /** A node may occur twice in a coupling: its springs meet there. */
  TEST(Families, MembersOfCommonNodesAddUpTheirBlocks)
  {
    Random random(403);
    for (const int dim : {2, 3})
      for (const SpringLaw law : laws)
        {
          const SpringKind &kind = couplings(dim, law);
          Family family(kind);
          for (const Nodes &nodes :
               {Nodes{0, 1, 0, 2}, Nodes{0, 2, 1, 2}, Nodes{0, 1, 1, 2}})
            family.add(nodes, random_numbers(kind, random));
          const Eigen::MatrixXd x = random.matrix(dim, 3);
          const auto gradient =
            [&](const Eigen::MatrixXd &y) -> Eigen::VectorXd {
            return -forces_of(family, y).reshaped();
          };
          const Eigen::MatrixXd K = derivative(gradient, x);
          EXPECT_LT(distance(tangent_by_products(family, x), K), 1e-7);
          EXPECT_LT(distance(tangent_of(family, x), K), 1e-7);
          const Eigen::MatrixXd blocks = diagonal_blocks_of(family, x);
          for (int v = 0; v < 3; ++v)
            EXPECT_LT(distance(blocks.middleCols(dim * v, dim),
                               K.block(dim * v, dim * v, dim, dim)),
                      1e-7);
        }
  }

  TEST(Families, TheConvexTangentIsTheSumOfPositiveParts)
  {
    Random random(404);
    for_every_kind([&](const SpringKind &kind) {
      const auto [family, x]       = random_sample(kind, 7, random);
      const Eigen::MatrixXd convex = convex_tangent_of(family, x);
      const Eigen::MatrixXd expected =
        assembled(family, x, [f = family, y = x](const std::size_t m) {
          const Eigen::MatrixXd H = f.kind->hessian(f.members, m, y);
          const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(H);
          Eigen::MatrixXd positive = Eigen::MatrixXd::Zero(H.rows(), H.cols());
          for (Eigen::Index i = 0; i < H.rows(); ++i)
            if (solver.eigenvalues()[i] > 0.)
              positive += solver.eigenvalues()[i] *
                          solver.eigenvectors().col(i) *
                          solver.eigenvectors().col(i).transpose();
          return positive;
        });
      EXPECT_GT(convex.norm(), 0.1);
      EXPECT_LT(distance(convex, expected), 1e-12);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(convex);
      EXPECT_GT(solver.eigenvalues()[0], -1e-13 * convex.norm());
    });
  }

  TEST(Families, RigidMotionsCostNothing)
  {
    Random random(405);
    for_every_kind([&](const SpringKind &kind) {
      const auto [family, x]  = random_sample(kind, 7, random);
      const int dim           = x.rows();
      const double U          = energy_of(family, x);
      const Eigen::MatrixXd Q = random.rotation(dim);
      const Eigen::VectorXd t = random.matrix(dim, 1);
      const Eigen::MatrixXd y = (Q * x).colwise() + t;
      EXPECT_NEAR(energy_of(family, y), U, 1e-12 * (1. + std::abs(U)));
      EXPECT_LT(distance(forces_of(family, y), Q * forces_of(family, x)),
                1e-12);
    });
  }

  /** Operations that take several members at once have a rest at the end. */
  TEST(Families, AreTheSumOfTheirMembers)
  {
    Random random(406);
    for_every_kind([&](const SpringKind &kind) {
      for (const unsigned int n_members : {0, 1, 2, 3, 4, 5, 7, 11})
        {
          const auto [family, x]  = random_sample(kind, n_members, random);
          const Eigen::MatrixXd u = random.matrix(x.rows(), x.cols());
          double U                = 0.;
          Eigen::MatrixXd forces = zero_like(x), product = forces;
          Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
          for (std::size_t m = 0; m < n_members; ++m)
            {
              const Family single = selected(family, {m});
              ASSERT_EQ(single.size(), 1u);
              U += energy_of(single, x);
              forces += forces_of(single, x);
              product += product_of(single, x, u);
              K += tangent_of(single, x);
            }
          EXPECT_NEAR(energy_of(family, x), U, 1e-13 * (1. + std::abs(U)));
          EXPECT_LT(distance(forces_of(family, x), forces), 1e-13);
          EXPECT_LT(distance(product_of(family, x, u), product), 1e-13);
          EXPECT_LT(distance(tangent_of(family, x), K), 1e-13);
        }
    });
  }

  /** Rows of springs from one node, sorted and in disorder. */
  TEST(Families, RowsOfSpringsAreTheSumOfTheirMembers)
  {
    Random random(407);
    for_every_kind([&](const SpringKind &kind) {
      if (kind.n_nodes() != 2)
        return;
      const Eigen::MatrixXd x = random.matrix(dimension_of(kind), 6);
      const Eigen::MatrixXd u = random.matrix(x.rows(), 6);
      Family sorted(kind);
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = i + 1; j < 6; ++j)
          sorted.add({i, j}, random_numbers(kind, random));
      std::vector<std::size_t> order(sorted.size());
      std::iota(order.begin(), order.end(), 0);
      for (std::size_t m = order.size() - 1; m > 0; --m)
        std::swap(order[m], order[std::size_t(random() * (m + 1))]);
      Eigen::MatrixXd forces = zero_like(x), product = forces;
      for (std::size_t m = 0; m < sorted.size(); ++m)
        {
          forces += forces_of(selected(sorted, {m}), x);
          product += product_of(selected(sorted, {m}), x, u);
        }
      for (const Family &family : {sorted, selected(sorted, order)})
        {
          EXPECT_LT(distance(forces_of(family, x), forces), 1e-13);
          EXPECT_LT(distance(product_of(family, x, u), product), 1e-13);
        }
    });
  }

  /**
   * Of what power of its size the energy of a cell is, with the same material:
   * of surfaces in space the second.
   */
  int
  power_of_energy(const SpringKind &kind)
  {
    for (const Column &column : kind.columns())
      if (column.name == "rest_volume")
        return column.power;
    return dimension_of(kind);
  }

  TEST(Families, ScaledCopiesHaveTheTangentOfTheScaledCell)
  {
    Random random(408);
    const double s = 0.37;
    for_every_kind([&](const SpringKind &kind) {
      const auto [family, x] = random_sample(kind, 1, random, 1);
      const int dim          = x.rows();
      const int power        = power_of_energy(kind);
      // The scaled cell has other numbers in the network.
      Eigen::MatrixXd nodes = 7. * random.matrix(dim, x.cols() + 2);
      Nodes vertices        = first_nodes(x.cols());
      for (unsigned int &v : vertices)
        v = x.cols() + 1 - v;
      nodes(Eigen::all, vertices) = s * x;
      NetworkBuilder builder(nodes);
      builder.add(scaled(family, s), vertices);
      const auto network = builder.build();
      ASSERT_EQ(network.families.size(), 1u);
      ASSERT_EQ(network.families[0].size(), 1u);

      const Eigen::MatrixXd y      = x + 0.05 * random.matrix(dim, x.cols());
      Eigen::MatrixXd places       = nodes;
      places(Eigen::all, vertices) = s * y;
      const auto &copy             = network.families[0];
      const double U               = energy_of(family, y);
      EXPECT_NEAR(energy_of(copy, places) / std::pow(s, power),
                  U,
                  1e-13 * (1. + std::abs(U)));
      EXPECT_LT(distance(forces_of(copy, places)(Eigen::all, vertices) /
                           std::pow(s, power - 1),
                         forces_of(family, y)),
                1e-12);
      std::vector<Eigen::Index> dofs;
      for (const unsigned int v : vertices)
        for (int d = 0; d < dim; ++d)
          dofs.push_back(dim * v + d);
      EXPECT_LT(distance(tangent_of(copy, places)(dofs, dofs) /
                           std::pow(s, power - 2),
                         tangent_of(family, y)),
                1e-12);
    });
  }

  /** Whatever members are merged, forces are those of all of them. */
  TEST(Families, MembersOfTheSameNodesMergeWithoutChange)
  {
    Random random(409);
    for_every_kind([&](const SpringKind &kind) {
      const auto [family, x] = random_sample(kind, 11, random);
      const Nodes all        = first_nodes(x.cols());
      for (const bool other_rest_values : {false, true})
        {
          Family cells = selected(family, {0, 1, 2});
          if (other_rest_values)
            cells = family;
          else
            for (std::size_t m = 3; m < family.size(); ++m)
              {
                // A stiffness of its own, the rest that of the first ones.
                Numbers numbers = cells.numbers(m % 3);
                if (kind.columns()[0].role == Column::Role::stiffness)
                  numbers[0] = family.numbers(m)[0];
                cells.add({family.nodes(m), family.nodes(m) + kind.n_nodes()},
                          numbers);
              }
          NetworkBuilder builder(x);
          builder.add(cells, all);
          const auto network = builder.build();
          ASSERT_EQ(network.families.size(), 1u);
          const Family &merged = network.families[0];
          if (!kind.is_shared())
            EXPECT_EQ(merged.size(), cells.size());
          else if (!other_rest_values || kind.rest_values_average())
            EXPECT_EQ(merged.size(), 3u);
          else
            EXPECT_EQ(merged.size(), cells.size());

          EXPECT_TRUE(std::isfinite(energy_of(merged, x)));
          const Eigen::MatrixXd y =
            x + 0.05 * random.matrix(x.rows(), x.cols());
          EXPECT_NEAR(energy_of(merged, y) - energy_of(merged, x),
                      energy_of(cells, y) - energy_of(cells, x),
                      1e-12);
          if (!other_rest_values)
            EXPECT_NEAR(energy_of(merged, x), energy_of(cells, x), 1e-12);
          EXPECT_LT(distance(forces_of(merged, y), forces_of(cells, y)), 1e-12);
          EXPECT_LT(distance(tangent_of(merged, y), tangent_of(cells, y)),
                    1e-12);
        }
    });
  }

  TEST(Families, HookeanSpringsOfSeveralRestLengthsHaveTheirWeightedMean)
  {
    for (const int dim : {2, 3})
      {
        Random random(410);
        const Eigen::MatrixXd x = random.matrix(dim, 2);
        const auto built        = [&](const SpringLaw law, const double k) {
          Family family(lengths(dim, law));
          family.add({0, 1}, {{2.}, {0.5}});
          family.add({0, 1}, {{k}, {0.9}});
          NetworkBuilder builder(x);
          builder.add(family, {0, 1});
          return builder.build().families[0];
        };
        const Family mean = built(SpringLaw::quadratic, 6.);
        ASSERT_EQ(mean.size(), 1u);
        EXPECT_DOUBLE_EQ(mean.members.columns[0][0], 8.);
        EXPECT_DOUBLE_EQ(mean.members.columns[1][0], 0.8);
        // No mean would give the force of springs that cancel.
        EXPECT_EQ(built(SpringLaw::quadratic, -2.).size(), 2u);
        EXPECT_EQ(built(SpringLaw::biquadratic, 6.).size(), 2u);
        const Eigen::MatrixXd f =
          forces_of(built(SpringLaw::quadratic, -2.), x);
        // 2 (l - 0.5) - 2 (l - 0.9)
        const Eigen::VectorXd n = (x.col(1) - x.col(0)).normalized();
        EXPECT_LT((f.col(0) - 0.8 * n).norm(), 1e-14);
        EXPECT_LT((f.col(1) + 0.8 * n).norm(), 1e-14);
      }
  }


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


  // Volumes.

  TEST(Volumes, AreTheCoordinateOfTheirSprings)
  {
    Random random(417);
    for (const CellKind kind : oracle::all_kinds)
      for (int repetition = 0; repetition < 20; ++repetition)
        {
          Eigen::MatrixXd x = oracle::random_cell(kind, random);
          if (repetition % 4 == 3)
            x.row(0) *= -1.; // inside out
          const double k = random(-2., 2.), rest = random(0.1, 1.);
          Family family(volumes(kind));
          family.add(first_nodes(x.cols()), {{k}, {rest}});
          const double V          = volume(x, kind);
          const Eigen::VectorXd g = volume_gradient(x, kind);
          const Eigen::MatrixXd H = volume_hessian(x, kind);
          EXPECT_NEAR(energy_of(family, x),
                      0.5 * k * (V - rest) * (V - rest),
                      1e-14);
          EXPECT_LT(
            (forces_of(family, x).reshaped() + k * (V - rest) * g).norm(),
            1e-14);
          EXPECT_LT((family.kind->hessian(family.members, 0, x) -
                     k * (g * g.transpose() + (V - rest) * H))
                      .norm(),
                    1e-14);
        }
  }

  /** Of the points, from energies k (V_g - 0)^2 / 2 and k (V_g - 1)^2 / 2. */
  Eigen::VectorXd
  volumes_at_points(const Eigen::MatrixXd &x, const CellKind cell)
  {
    const SpringKind &kind = point_volumes(cell);
    const int n            = x.cols();
    Eigen::VectorXd V(n);
    for (int g = 0; g < n; ++g)
      {
        std::vector<double> k(n, 0.);
        k[g] = 1.;
        Family at_zero(kind), at_one(kind);
        at_zero.add(first_nodes(n), {k, std::vector<double>(n, 0.)});
        at_one.add(first_nodes(n), {k, std::vector<double>(n, 1.)});
        V[g] = energy_of(at_zero, x) - energy_of(at_one, x) + 0.5;
      }
    return V;
  }

  TEST(PointVolumes, AreTheMapsDeterminantsAndSumToTheVolume)
  {
    Random random(418);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      for (int repetition = 0; repetition < 20; ++repetition)
        {
          const int dim           = dimension(kind);
          const int n             = n_vertices(kind);
          const Eigen::MatrixXd x = oracle::random_cell(kind, random);
          const Eigen::VectorXd V = volumes_at_points(x, kind);
          EXPECT_NEAR(V.sum(), volume(x, kind), 1e-14);
          for (int g = 0; g < n; ++g)
            {
              // The derivatives of the map at 1/2 (1 +- 1 / sqrt 3).
              Eigen::MatrixXd J = Eigen::MatrixXd::Zero(dim, dim);
              for (int v = 0; v < n; ++v)
                for (int d = 0; d < dim; ++d)
                  {
                    double slope = 1.;
                    for (int e = 0; e < dim; ++e)
                      {
                        const double xi =
                          0.5 + (g >> e & 1 ? 0.5 : -0.5) / std::sqrt(3.);
                        const bool upper = v >> e & 1;
                        slope *=
                          e == d ? (upper ? 1. : -1.) : (upper ? xi : 1. - xi);
                      }
                    J.col(d) += slope * x.col(v);
                  }
              EXPECT_NEAR(V[g], J.determinant() / n, 1e-14);
            }
        }
  }

  /** With all pressures equal the sum of the points is the whole. */
  TEST(PointVolumes, PushAsTheVolumeUnderAUniformPressure)
  {
    Random random(419);
    for (const CellKind kind : {CellKind::quadrilateral, CellKind::hexahedron})
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const int n             = x.cols();
        const Eigen::VectorXd V = volumes_at_points(x, kind);
        std::vector<double> k(n), rest(n);
        for (int g = 0; g < n; ++g)
          {
            k[g]    = random(0.5, 1.5);
            rest[g] = V[g] - 0.7 / k[g];
          }
        Family family(point_volumes(kind));
        family.add(first_nodes(n), {k, rest});
        EXPECT_LT((forces_of(family, x).reshaped() +
                   0.7 * volume_gradient(x, kind))
                    .norm(),
                  1e-13);
      }
  }


  // The parts of the neo-Hookean material.

  /** - mu times the integrals of grad N_a . grad N_b, on all pairs. */
  Family
  shear_springs(const Eigen::MatrixXd &x, const CellKind kind, const double mu)
  {
    const int n               = x.cols();
    Eigen::MatrixXd integrals = Eigen::MatrixXd::Zero(n, n);
    for (const auto &point : cell_quadrature(kind))
      {
        const Eigen::MatrixXd J = x * point.gradients.transpose();
        const Eigen::MatrixXd gradients =
          J.inverse().transpose() * point.gradients;
        integrals +=
          point.weight * J.determinant() * gradients.transpose() * gradients;
      }
    Family family(zero_lengths(x.rows()));
    for (const auto &[a, b] : node_pairs(kind))
      family.add({a, b}, {{-mu * integrals(a, b)}, {0.}});
    return family;
  }

  TEST(ZeroLengths, HaveTheEnergyOfTheSquaredDeformationGradient)
  {
    Random random(420);
    const double mu = 0.8;
    for (const CellKind kind : oracle::all_kinds)
      for (int repetition = 0; repetition < 20; ++repetition)
        {
          const int dim           = dimension(kind);
          const Eigen::MatrixXd x = oracle::random_cell(kind, random);
          const Family family     = shear_springs(x, kind, mu);
          const Eigen::MatrixXd F = random.matrix(dim, dim);
          const Eigen::VectorXd t = random.matrix(dim, 1);
          const double expected = 0.5 * mu * volume(x, kind) * F.squaredNorm();
          EXPECT_NEAR(energy_of(family, (F * x).colwise() + t),
                      expected,
                      1e-13);

          const Eigen::MatrixXd y = random.matrix(dim, x.cols());
          const Eigen::MatrixXd z = random.matrix(dim, x.cols());
          EXPECT_LT((forces_of(family, 2. * y - 3. * z) -
                     (2. * forces_of(family, y) - 3. * forces_of(family, z)))
                      .norm(),
                    1e-12);
          EXPECT_LT((product_of(family, y, z) + forces_of(family, z)).norm(),
                    1e-13);
        }
  }

  /** Kinds of the logarithmic law, of one coordinate or of several. */
  std::vector<const SpringKind *>
  logarithmic_kinds(const CellKind cell, const bool plane_stress)
  {
    std::vector<const SpringKind *> kinds = {
      plane_stress ? &logarithmic_areas_in_plane_stress(cell)
                   : &logarithmic_volumes(cell)};
    if (!is_simplex(cell))
      kinds.push_back(plane_stress
                        ? &logarithmic_point_areas_in_plane_stress(cell)
                        : &logarithmic_point_volumes(cell));
    return kinds;
  }

  Eigen::VectorXd
  coordinates_of(const SpringKind &kind,
                 const Eigen::MatrixXd &x,
                 const CellKind cell)
  {
    if (kind.columns()[0].width == 1)
      return Eigen::VectorXd::Constant(1, volume(x, cell));
    return volumes_at_points(x, cell);
  }

  /** Of constants mu, lambda and rest volumes a member's energy is their sum.
   */
  template <typename EnergyOf>
  void
  check_logarithmic_law(const bool plane_stress, const EnergyOf &energy_of_J)
  {
    Random random(421);
    for (const CellKind cell : oracle::all_kinds)
      {
        if (plane_stress && dimension(cell) != 2)
          continue;
        for (const SpringKind *kind : logarithmic_kinds(cell, plane_stress))
          for (int repetition = 0; repetition < 10; ++repetition)
            {
              SCOPED_TRACE(name_of(*kind));
              Family family(*kind);
              family.add(first_nodes(kind->n_nodes()),
                         random_numbers(*kind, random));
              const auto &mu          = family.members.columns[0];
              const auto &lambda      = family.members.columns[1];
              const auto &rest        = family.members.columns[2];
              const Eigen::MatrixXd x = random_places(*kind, random);
              const Eigen::VectorXd V = coordinates_of(*kind, x, cell);
              double expected         = 0.;
              for (Eigen::Index g = 0; g < V.size(); ++g)
                expected +=
                  rest[g] * energy_of_J(V[g] / rest[g], mu[g], lambda[g]);
              EXPECT_NEAR(energy_of(family, x), expected, 1e-12);
            }
      }
  }

  TEST(LogarithmicVolumes, HaveTheEnergyOfTheLaw)
  {
    check_logarithmic_law(
      false, [](const double J, const double mu, const double lambda) {
        return -mu * std::log(J) + 0.5 * lambda * std::log(J) * std::log(J);
      });
  }

  /**
   * The least energy of the body over its square of the stretch across the
   * plane, by golden sections in the logarithm. For nu < 0 it is the least one
   * near rest, where the energy is convex: a sheet without thickness has none.
   */
  double
  least_energy(const double J, const double mu, const double lambda)
  {
    const double lambda_3 = 2. * mu * lambda / (2. * mu - lambda);
    const auto energy     = [&](const double log_c) {
      const double log_J = std::log(J) + 0.5 * log_c;
      return 0.5 * mu * (std::exp(log_c) - 1.) - mu * log_J +
             0.5 * lambda_3 * log_J * log_J;
    };
    const double section = 0.5 * (std::sqrt(5.) - 1.);
    double low  = lambda_3 < 0. ? std::log(-0.5 * lambda_3 / mu) : -12.;
    double high = 12.;
    while (high - low > 1e-9)
      {
        const double a = high - section * (high - low);
        const double b = low + section * (high - low);
        if (energy(a) < energy(b))
          high = b;
        else
          low = a;
      }
    return energy(0.5 * (low + high));
  }

  TEST(LogarithmicAreasInPlaneStress, HaveTheLeastEnergyOverTheThickness)
  {
    check_logarithmic_law(true, least_energy);
  }

  /** The force along the gradient of the volume is the slope of the law. */
  TEST(LogarithmicAreasInPlaneStress, PushWithTheSlopeOfTheLeastEnergy)
  {
    Random random(422);
    for (const CellKind cell : {CellKind::triangle, CellKind::quadrilateral})
      {
        const SpringKind &kind = logarithmic_areas_in_plane_stress(cell);
        for (const double J : {0.2, 0.7, 1., 1.3, 3.})
          for (const double nu : {-0.3, 0., 0.3, 0.49, 0.5})
            {
              const Eigen::MatrixXd x = oracle::random_cell(cell, random);
              const double V          = volume(x, cell);
              const double mu         = 0.5 / (1. + nu);
              const double lambda     = nu / (1. - nu * nu);
              Family family(kind);
              family.add(first_nodes(kind.n_nodes()),
                         {{mu}, {lambda}, {V / J}});
              // Under much compression such a sheet finds no thickness.
              if (nu < 0. && J < 0.5)
                {
                  EXPECT_EQ(energy_of(family, x),
                            std::numeric_limits<double>::infinity());
                  EXPECT_TRUE(forces_of(family, x).isZero(0.));
                  continue;
                }
              const auto gradient =
                [&](const Eigen::MatrixXd &y) -> Eigen::VectorXd {
                return -forces_of(family, y).reshaped();
              };
              EXPECT_LT(distance(tangent_of(family, x),
                                 derivative(gradient, x)),
                        1e-7);
              const Eigen::VectorXd g = volume_gradient(x, cell);
              const Eigen::VectorXd f = forces_of(family, x).reshaped();
              const double slope      = -f.dot(g) / g.squaredNorm();
              EXPECT_LT((f + slope * g).norm(), 1e-13);
              // Without pressure a body without Poisson's effect keeps its
              // thickness; one that keeps its volume has c = 1 / J^2.
              if (nu == 0.)
                EXPECT_NEAR(slope, -mu / J, 1e-13);
              if (nu == 0.5)
                EXPECT_NEAR(slope, -mu / (J * J * J), 1e-11);
              else
                {
                  const double h = 1e-3;
                  const auto U   = [&](const double steps) {
                    return least_energy(J + steps * h * J, mu, lambda);
                  };
                  EXPECT_NEAR(slope,
                              (8. * (U(1.) - U(-1.)) - (U(2.) - U(-2.))) /
                                (12. * h * J),
                              1e-9 / J);
                }
            }
      }
  }

  /** In plane strain, space and plane stress alike, at rest nothing pushes. */
  TEST(LogarithmicVolumes, WithZeroLengthsAreAtRestInTheShapeOfTheCell)
  {
    Random random(423);
    const double nu = 0.3, mu = 0.5 / (1. + nu);
    for (const CellKind cell : oracle::all_kinds)
      for (const bool plane_stress : {false, true})
        {
          if (plane_stress && dimension(cell) != 2)
            continue;
          const int dim           = dimension(cell);
          const double lambda     = plane_stress
                                      ? nu / (1. - nu * nu)
                                      : nu / ((1. + nu) * (1. - 2. * nu));
          const Eigen::MatrixXd x = oracle::random_cell(cell, random);
          const Family shear      = shear_springs(x, cell, mu);
          // The finest ones: the element itself.
          const SpringKind &kind =
            *logarithmic_kinds(cell, plane_stress).back();
          const Eigen::VectorXd V = coordinates_of(kind, x, cell);
          const std::size_t n     = V.size();
          Family volumetric(kind);
          volumetric.add(first_nodes(x.cols()),
                         {std::vector<double>(n, mu),
                          std::vector<double>(n, lambda),
                          std::vector<double>(V.begin(), V.end())});
          EXPECT_LT((forces_of(shear, x) + forces_of(volumetric, x)).norm(),
                    1e-13);
          // Its tangent there is that of linear elasticity.
          const Eigen::MatrixXd K =
            oracle::stiffness(x, cell, oracle::isotropic(dim, lambda, mu));
          EXPECT_LT(distance(Eigen::MatrixXd(tangent({shear, volumetric}, x)),
                             K),
                    1e-12);
        }
  }


  // Several families as one body.

  /** A cell with springs of every kind of enrichment. */
  SpringNetwork
  full_network(const CellKind kind, const SpringLaw law, Random &random)
  {
    const Eigen::MatrixXd x = oracle::random_cell(kind, random);
    const Nodes vertices    = first_nodes(x.cols());
    const auto &pairs       = node_pairs(kind);
    const auto &triples     = cell_angles(kind);
    NetworkBuilder builder(x);
    builder.add(lengths_at_rest(x, pairs, random.matrix(pairs.size(), 1), law),
                vertices);
    builder.add(couplings_at_rest(x, pairs, {{0, 1, 0.7}, {1, 2, -0.4}}, law),
                vertices);
    builder.add(angles_at_rest(x, triples, random.matrix(triples.size(), 1)),
                vertices);
    builder.add(volume_at_rest(x, kind, 2.), vertices);
    return builder.build();
  }

  TEST(Network, IsConsistentAndHasTheGradientsTangentAtRest)
  {
    Random random(52);
    for (const CellKind cell : oracle::all_kinds)
      for (const SpringLaw law : laws)
        {
          const auto network = full_network(cell, law, random);
          ASSERT_EQ(network.families.size(), 4u);
          const Family &springs = network.families[0];
          const Family &coupled = network.families[1];
          const Family &angular = network.families[2];
          EXPECT_EQ(springs.size(), node_pairs(cell).size());
          EXPECT_EQ(coupled.size(), 2u);
          EXPECT_EQ(angular.size(), cell_angles(cell).size());
          EXPECT_EQ(network.families[3].size(), 1u);

          const auto U = [&](const Eigen::MatrixXd &y) {
            return scalar(energy(network.families, y));
          };
          const auto gradient =
            [&](const Eigen::MatrixXd &y) -> Eigen::VectorXd {
            Eigen::MatrixXd forces = zero_like(y);
            add_forces(network.families, y, forces);
            return -forces.reshaped();
          };
          const Eigen::MatrixXd &rest = network.nodes;
          const Eigen::MatrixXd x =
            rest + 0.1 * random.matrix(rest.rows(), rest.cols());
          EXPECT_LT((derivative(U, x).transpose() - gradient(x)).norm(), 1e-7);
          EXPECT_LT((derivative(gradient, x) -
                     Eigen::MatrixXd(tangent(network.families, x)))
                      .norm(),
                    1e-6);
          const Eigen::MatrixXd u = random.matrix(x.rows(), x.cols());
          Eigen::MatrixXd product = zero_like(x);
          add_tangent_product(network.families, x, u, product);
          EXPECT_LT((product.reshaped() -
                     tangent(network.families, x) * u.reshaped())
                      .norm(),
                    1e-12);

          // At rest the tangent is that of the gradients b_s, whatever the law.
          std::vector<NodePair> pairs;
          for (std::size_t s = 0; s < springs.size(); ++s)
            pairs.push_back({{springs.nodes(s)[0], springs.nodes(s)[1]}});
          const Eigen::MatrixXd B = length_gradients(rest, pairs);
          Eigen::MatrixXd K       = Eigen::MatrixXd::Zero(x.size(), x.size());
          for (Eigen::Index s = 0; s < B.cols(); ++s)
            K +=
              springs.members.columns[0][s] * B.col(s) * B.col(s).transpose();
          for (std::size_t m = 0; m < coupled.size(); ++m)
            {
              const unsigned int *nodes = coupled.nodes(m);
              const Eigen::MatrixXd b   = length_gradients(
                rest, {{{nodes[0], nodes[1]}}, {{nodes[2], nodes[3]}}});
              K += coupled.members.columns[0][m] *
                   (b.col(0) * b.col(1).transpose() +
                    b.col(1) * b.col(0).transpose());
            }
          for (std::size_t m = 0; m < angular.size(); ++m)
            {
              const unsigned int *nodes = angular.nodes(m);
              const Eigen::VectorXd b =
                angle_gradients(rest, {{{nodes[0], nodes[1], nodes[2]}}});
              K += angular.members.columns[0][m] * b * b.transpose();
            }
          const Eigen::VectorXd b = volume_gradient(rest, cell);
          K += 2. * b * b.transpose();
          EXPECT_LT(gradient(rest).norm(), 1e-13);
          EXPECT_LT(
            (Eigen::MatrixXd(tangent(network.families, rest)) - K).norm(),
            1e-12);
        }
  }

  TEST(Network, HasNoDerivativesWhereItIsDegenerate)
  {
    const Eigen::MatrixXd rest = oracle::regular_cell(CellKind::triangle);
    const Family spring        = lengths_at_rest(rest,
                                          {{0, 1}},
                                          Eigen::VectorXd::Ones(1),
                                          SpringLaw::quadratic);
    const Family angle =
      angles_at_rest(rest, {{0, 2, 1}}, Eigen::VectorXd::Ones(1));
    const double infinity = std::numeric_limits<double>::infinity();

    Eigen::MatrixXd x = rest;
    x(1, 2)           = 0.; // the apex between the others
    EXPECT_TRUE(std::isfinite(energy_of(spring, x)));
    EXPECT_EQ(energy_of(angle, x), infinity);
    EXPECT_EQ(energy({spring, angle}, x), infinity);
    x       = rest;
    x(0, 1) = 0.; // the two ends of the base at one place
    EXPECT_EQ(energy_of(spring, x), infinity);
    EXPECT_EQ(energy_of(angle, x), infinity);
    Eigen::MatrixXd forces = zero_like(x);
    add_forces({spring, angle}, x, forces);
    EXPECT_TRUE(forces.isZero(0.));
  }


  /**
   * The P1 cell as springs and couplings: C = B^-1 R B^-T in the basis of the
   * deformations.
   */
  SpringNetwork
  fully_coupled(const Eigen::MatrixXd &x, const Eigen::MatrixXd &R)
  {
    const CellKind kind     = cell_kind(x.rows(), x.cols());
    const auto &pairs       = node_pairs(kind);
    const Eigen::MatrixXd Q = deformation_basis(x);
    const Eigen::MatrixXd inverse =
      (Q.transpose() * length_gradients(x, pairs)).inverse();
    const Eigen::MatrixXd C =
      inverse * Q.transpose() * R * Q * inverse.transpose();
    std::vector<LengthCoupling> couplings;
    for (unsigned int a = 0; a < pairs.size(); ++a)
      for (unsigned int b = a + 1; b < pairs.size(); ++b)
        couplings.push_back({a, b, C(a, b)});
    const Nodes vertices = first_nodes(x.cols());
    const SpringLaw law  = SpringLaw::biquadratic;
    NetworkBuilder builder(x);
    builder.add(lengths_at_rest(x, pairs, C.diagonal(), law), vertices);
    builder.add(couplings_at_rest(x, pairs, couplings, law), vertices);
    return builder.build();
  }

  template <int dim>
  void
  check_st_venant_kirchhoff(const CellKind kind)
  {
    Random random(53);
    const double lambda = 1.7, mu = 0.6;
    for (int sample = 0; sample < 100; ++sample)
      {
        const Eigen::MatrixXd x = oracle::random_cell(kind, random);
        const double V          = std::abs(volume(x, kind));
        const auto network      = fully_coupled(
          x, oracle::stiffness(x, kind, oracle::isotropic(dim, lambda, mu)));

        // Any deformation of the cell is x -> F x + t, inside out or not.
        const Eigen::Matrix<double, dim, dim> F = 2. * random.matrix(dim, dim);
        const Eigen::VectorXd t                 = random.matrix(dim, 1);
        const Eigen::MatrixXd y                 = (F * x).colwise() + t;

        const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(dim, dim);
        const Eigen::MatrixXd E = 0.5 * (F.transpose() * F - I);
        const double expected =
          V * (0.5 * lambda * E.trace() * E.trace() + mu * E.squaredNorm());
        // Forces - V F S grad N_v with S = lambda tr(E) I + 2 mu E.
        const Eigen::MatrixXd S = lambda * E.trace() * I + 2. * mu * E;
        Eigen::MatrixXd gradients(dim, dim + 1);
        const Eigen::MatrixXd J    = x.rightCols(dim).colwise() - x.col(0);
        gradients.rightCols(dim)   = J.inverse().transpose();
        gradients.col(0)           = -gradients.rightCols(dim).rowwise().sum();
        const Eigen::MatrixXd pull = V * F * S * gradients;

        Eigen::MatrixXd forces = zero_like(y);
        add_forces(network.families, y, forces);
        EXPECT_NEAR(energy(network.families, y), expected, 1e-12 * expected);
        EXPECT_LT((forces + pull).norm(), 1e-12 * pull.norm());
      }
  }

  TEST(BiquadraticSprings, WithAllCouplingsAreStVenantKirchhoffsMaterial)
  {
    check_st_venant_kirchhoff<2>(CellKind::triangle);
    check_st_venant_kirchhoff<3>(CellKind::tetrahedron);
  }
} // namespace
