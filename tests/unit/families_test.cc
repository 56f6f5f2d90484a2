// The kinds of springs: what each does for a family of members, one against
// the other and against what a spring must keep.

#include <springfit/springs/couplings.h>
#include <springfit/springs/lengths.h>
#include <springfit/springs/network.h>
#include <springfit/springs/spring_kinds.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "derivative.h"
#include "families.h"

using namespace springfit;
using namespace springfit::oracle;

namespace
{
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
} // namespace
